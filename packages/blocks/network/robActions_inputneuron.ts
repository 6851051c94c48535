import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_inputneuron'

/** An old block, in IONEURON of robActions_NNstep: gives an input its value. */
export const robActions_inputneuron: Definition = {
  type,
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n1')],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame, context, block) => {
    context.memory.net().inputs[field(block, 'NAME')] = numberAt(frame, 0)
    return done
  }),
  example: [
    ...netStart,
    {
      type: 'robActions_NNstep',
      statements: { IONEURON: [{ type, fields: { NAME: 'n1' }, values: { VALUE: number(3) } }] },
    },
  ],
}
