import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { biasIn } from '../parts/nets.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_change_bias'

/** An old block. CHANGE SET puts VALUE in the bias's place, INCR adds it. */
export const robActions_change_bias: Definition = {
  type,
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
  run: afterAsking([ask('VALUE')], (frame, context, block) => {
    const name = field(block, 'NAME')
    if (biasIn(context, name) === null) return fail('noSuchNeuron', { name })
    const before = field(block, 'CHANGE', 'SET') === 'INCR' ? (biasIn(context, name) ?? 0) : 0
    context.memory.net().biases[name] = before + numberAt(frame, 0)
    return done
  }),
  example: [
    ...netStart,
    { type, fields: { NAME: 'n2', CHANGE: 'INCR' }, values: { VALUE: number(2) } },
    { type: 'robActions_NNstep' },
  ],
}
