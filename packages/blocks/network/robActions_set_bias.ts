import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, value, words } from '../parts/looks.ts'
import { biasIn } from '../parts/nets.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_set_bias'

export const robActions_set_bias: Definition = {
  type,
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n2')],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame, context, block) => {
    const name = field(block, 'NAME')
    if (biasIn(context, name) === null) return fail('noSuchNeuron', { name })
    context.memory.net().biases[name] = numberAt(frame, 0)
    return done
  }),
  example: [
    ...netStart,
    { type, fields: { NAME: 'n2' }, values: { VALUE: number(2) } },
    { type: 'robActions_NNstep' },
  ],
}
