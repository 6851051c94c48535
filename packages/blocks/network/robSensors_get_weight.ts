import { whole } from '../python.ts'
import { netStart } from '../parts/net-examples.ts'
import { show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { weightIn } from '../parts/nets.ts'
import { fail, give } from '../parts/next.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_get_weight'

export const robSensors_get_weight: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'network',
    shape: 'value',
    output: 'Number',
    fields: [nameField('neuron', 'n1', 'FROM'), nameField('neuron', 'n2', 'TO')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, _frame, context) {
    const weight = weightIn(context, field(block, 'FROM'), field(block, 'TO'))
    return weight === null
      ? fail('noSuchNeuron', { name: `${field(block, 'FROM')} → ${field(block, 'TO')}` })
      : give(weight)
  },
  python: (py) => whole(py.neuron('weights', py.field('FROM'), py.field('TO'))),
  example: [...netStart, show({ type, fields: { FROM: 'n1', TO: 'n2' } })],
}
