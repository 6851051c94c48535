import { changeWeight, pythonWeight } from '../parts/change-net.ts'
import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_set_weight'

/** From now on this run drives with this weight; the knobs stay. */
export const robActions_set_weight: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n1', 'FROM'), nameField('neuron', 'n2', 'TO')],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: changeWeight,
  python: pythonWeight,
  example: [
    ...netStart,
    { type, fields: { FROM: 'n1', TO: 'n2' }, values: { VALUE: number(2) } },
    { type: 'robActions_NNstep' },
  ],
}
