import { number } from '../parts/examples.ts'
import { inputNeuronValue } from '../parts/input-neuron-value.ts'
import { netStart } from '../parts/net-examples.ts'

const type = 'robActions_inputneuron'

/** An old block, in IONEURON of robActions_NNstep. */
export const robActions_inputneuron = inputNeuronValue(type, [
  ...netStart,
  {
    type: 'robActions_NNstep',
    statements: { IONEURON: [{ type, fields: { NAME: 'n1' }, values: { VALUE: number(3) } }] },
  },
])
