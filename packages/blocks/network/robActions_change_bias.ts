import { changeBias, pythonBias } from '../parts/change-net.ts'
import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_change_bias'

/** An old block. CHANGE SET puts VALUE in the bias's place, INCR adds it. */
export const robActions_change_bias: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [
      nameField('neuron', 'n2'),
      choice('CHANGE', [worded('SET', 'setNumber'), worded('INCR', 'increase')]),
    ],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: changeBias,
  python: pythonBias,
  example: [
    ...netStart,
    { type, fields: { NAME: 'n2', CHANGE: 'INCR' }, values: { VALUE: number(2) } },
    { type: 'robActions_NNstep' },
  ],
}
