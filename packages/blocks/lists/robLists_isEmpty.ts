import { compared } from '../parts/python.ts'
import { someList } from '../parts/lists.ts'
import { lampIf, start } from '../parts/examples.ts'
import { listInput } from '../parts/kinds.ts'
import { listAt } from '../parts/lists.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robLists_isEmpty'

export const robLists_isEmpty: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'lists',
    shape: 'value',
    output: 'Boolean',
    fields: [],
    inputs: [listInput('VALUE')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame) => give(listAt(frame, 0).length === 0)),
  python: (py) => compared(`len(${py.value('VALUE')})`, '==', '0'),
  example: [start, lampIf({ type, values: { VALUE: someList } })],
}
