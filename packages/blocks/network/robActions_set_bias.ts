import { changeBias, pythonBias } from '../parts/change-net.ts'
import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_set_bias'

export const robActions_set_bias: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n2')],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: changeBias,
  python: pythonBias,
  example: [
    ...netStart,
    { type, fields: { NAME: 'n2' }, values: { VALUE: number(2) } },
    { type: 'robActions_NNstep' },
  ],
}
