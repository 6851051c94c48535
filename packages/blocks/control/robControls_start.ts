import { part } from '../parts/python.ts'
import { number, show, start } from '../parts/examples.ts'
import { hidden, rows, words } from '../parts/looks.ts'
import { execute, done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_start'
const variables = execute('ST')

export const robControls_start: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'control',
    shape: 'hat',
    icon: 'play',
    fields: [hidden('DEBUG', 'FALSE')],
    inputs: [
      { name: 'ST', kind: 'statements', holds: 'variables', when: { attribute: 'declare', is: ['true'] } },
    ],
    mutation: { declare: 'false' },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  /** Variables of the program stand in ST (mutation `declare` true); their own type is in the expert pack. */
  run: (_block, frame) => (frame.stage++ === 0 ? variables : done),
  python: part,
  example: [start, show(number(1))],
}
