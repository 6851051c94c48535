import { rangeTimes } from '../parts/python.ts'
import { binds } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { plainKindField, typedBy } from '../parts/kinds.ts'
import { costOf, mostEntries } from '../parts/lists.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robLists_repeat'

/** A new list of NUM times ITEM. */
export const robLists_repeat: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'Array_Number',
    fields: [plainKindField('LIST_TYPE')],
    inputs: [{ name: 'ITEM', kind: 'value', accepts: [] }, value('NUM', 'Number')],
    typed: typedBy({ field: 'LIST_TYPE' }, { output: 'list', inputs: { ITEM: 'type' } }),
    mutation: { list_type: { field: 'LIST_TYPE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('ITEM'), ask('NUM')], (frame) => {
    const count = Math.max(0, Math.ceil(numberAt(frame, 1)))
    if (count > mostEntries) return fail('listTooLong', { most: mostEntries })
    return {
      next: 'done',
      value: Array.from({ length: count }, () => frame.got[0] ?? null),
      cost: costOf(count),
    }
  }),
  python: (py) => {
    const count = rangeTimes(py, py.value('NUM', binds.sign))
    return { code: `[${py.value('ITEM')}] * ${count}`, binds: binds.product }
  },
  example: [
    start,
    show({
      type: 'robLists_length',
      values: {
        VALUE: {
          type,
          mutation: { attrs: { list_type: 'Number' } },
          fields: { LIST_TYPE: 'Number' },
          values: { ITEM: number(1), NUM: number(5) },
        },
      },
    }),
  ],
}
