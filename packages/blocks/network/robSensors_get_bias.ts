import { whole } from '../python.ts'
import { netStart } from '../parts/net-examples.ts'
import { show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { biasIn } from '../parts/nets.ts'
import { fail, give } from '../parts/next.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_get_bias'

export const robSensors_get_bias: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'network',
    shape: 'value',
    output: 'Number',
    fields: [nameField('neuron', 'n2')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, _frame, context) {
    const name = field(block, 'NAME')
    const bias = biasIn(context, name)
    return bias === null ? fail('noSuchNeuron', { name }) : give(bias)
  },
  python: (py) => whole(py.neuron('biases', py.field('NAME'))),
  example: [...netStart, show({ type, fields: { NAME: 'n2' } })],
}
