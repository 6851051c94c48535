import { filledNames } from '../parts/python.ts'
import { whole } from '../python.ts'
import { someList } from '../parts/lists.ts'
import { show, start } from '../parts/examples.ts'
import { plainKindField, typedBy } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { plugged, rowCount, rowName } from '../parts/rows.ts'
import type { Definition } from '../types.ts'

const type = 'robLists_create_with'

/** ADD0, ADD1, … (mutation `items`, `list_type`) as a new list of LIST_TYPE. Empty rows are skipped. */
export const robLists_create_with: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'Array_Number',
    fields: [plainKindField('LIST_TYPE')],
    inputs: [],
    typed: typedBy({ field: 'LIST_TYPE' }, { output: 'list', items: 'type' }),
    mutation: { list_type: { field: 'LIST_TYPE' } },
    items: { prefix: 'ADD', min: 0, max: 999 },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const count = rowCount(block)
    while (frame.stage < count) {
      const row = rowName(frame.stage++)
      if (plugged(block, row)) return ask(row)
    }
    return give([...frame.got])
  },
  python: (py) =>
    whole(
      `[${filledNames(py.block)
        .map((name) => py.value(name))
        .join(', ')}]`,
    ),
  example: [start, show({ type: 'robLists_length', values: { VALUE: someList } })],
}
