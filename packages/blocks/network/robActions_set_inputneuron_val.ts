import { netStart } from '../parts/net-examples.ts'
import { field } from '../parts/fields.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_set_inputneuron_val'

/** Gives an input of the network its value, until it is set again. */
export const robActions_set_inputneuron_val: Definition = {
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
  example: [...netStart],
}
