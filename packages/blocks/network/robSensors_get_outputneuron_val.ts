import { whole } from '../python.ts'
import { netStart } from '../parts/net-examples.ts'
import { outputIn } from '../parts/nets.ts'
import { show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_get_outputneuron_val'

/** What an output of the network gave in its last run; 0 before. */
export const robSensors_get_outputneuron_val: Definition = {
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
  run: (block, _frame, context) => give(outputIn(context, field(block, 'NAME'))),
  python: (py) => whole(py.neuron('outputs', py.field('NAME'))),
  example: [...netStart, { type: 'robActions_NNstep' }, show({ type, fields: { NAME: 'n2' } })],
}
