import { inputNeuronValue } from '../parts/input-neuron-value.ts'
import { netStart } from '../parts/net-examples.ts'

export const robActions_set_inputneuron_val = inputNeuronValue('robActions_set_inputneuron_val', 'expert', [
  ...netStart,
])
