import { setWeight } from '../parts/nets.ts'
import { netStart } from '../parts/net-examples.ts'
import { number } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, value, words } from '../parts/looks.ts'
import { weightIn } from '../parts/nets.ts'
import { ask, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_set_weight'

/** From now on this run drives with this weight; the knobs stay. */
export const robActions_set_weight: Definition = {
  type,
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n1', 'FROM'), nameField('neuron', 'n2', 'TO')],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame, context, block) => {
    const from = field(block, 'FROM')
    const to = field(block, 'TO')
    if (weightIn(context, from, to) === null) return fail('noSuchNeuron', { name: `${from} → ${to}` })
    setWeight(context, from, to, numberAt(frame, 0))
    return done
  }),
  example: [
    ...netStart,
    { type, fields: { FROM: 'n1', TO: 'n2' }, values: { VALUE: number(2) } },
    { type: 'robActions_NNstep' },
  ],
}
