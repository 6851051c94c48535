import { of } from '../parts/python.ts'
import { someList } from '../parts/lists.ts'
import { show, start } from '../parts/examples.ts'
import { listInput } from '../parts/kinds.ts'
import { listAt } from '../parts/lists.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robLists_length'

export const robLists_length: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [listInput('VALUE')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame) => give(listAt(frame, 0).length)),
  python: of('len', 'VALUE'),
  example: [start, show({ type, values: { VALUE: someList } })],
}
