import { motorNeuron, netProgram } from '../parts/examples.ts'
import { sensorPort } from '../parts/looks.ts'
import { inputNeuron } from '../parts/neurons.ts'

const type = 'ai_nn_input_node_coloursensor_light'

/** How bright the floor is, 0..100. */
export const ai_nn_input_node_coloursensor_light = inputNeuron({
  type,
  pack: 'core',
  sensor: 'colour',
  port: 'SENSORPORT',
  fields: [sensorPort('1')],
  label: 'neuron.light',
  colour: 'sensor',
  mode: 'light',
  level: Number,
  example: netProgram([{ type, fields: { SENSORPORT: '1' } }], [motorNeuron('C')]),
})
