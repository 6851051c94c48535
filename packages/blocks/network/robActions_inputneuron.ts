import { number } from '../parts/examples.ts'
import { inputNeuronValue } from '../parts/input-neuron-value.ts'
import { netStart } from '../parts/net-examples.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_inputneuron'

/** An old block, in IONEURON of robActions_NNstep. */
export const robActions_inputneuron: Definition = {
  ...inputNeuronValue(type, 'expert', [
    ...netStart,
    {
      type: 'robActions_NNstep',
      statements: { IONEURON: [{ type, fields: { NAME: 'n1' }, values: { VALUE: number(3) } }] },
    },
  ]),
  outsideToolbox: 'old',
}
