import { distanceNeuron, motorNeuron, netProgram } from '../parts/examples.ts'
import { choice, worded } from '../parts/looks.ts'
import { inputNeuron } from '../parts/neurons.ts'

const port = choice(
  'INPUTNODE',
  ['1', '2', '3', '4'].map((port) => worded(`ULTRASONIC_PORT_${port}`, `port${port}`)),
  'ULTRASONIC_PORT_2',
)

/** Distance to the next thing in cm, at most 100. */
export const ai_nn_input_node_ultrasonic = inputNeuron({
  type: 'ai_nn_input_node_ultrasonic',
  pack: 'core',
  sensor: 'ultrasonic',
  port: 'INPUTNODE',
  prefix: 'ULTRASONIC_PORT_',
  fields: [port],
  label: 'neuron.distance',
  colour: 'sensor',
  mode: 'distance',
  level: (cm) => Math.min(Number(cm), 100),
  example: netProgram([distanceNeuron('2')], [motorNeuron('C')]),
})
