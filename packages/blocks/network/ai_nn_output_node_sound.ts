import { distanceNeuron, netProgram } from '../parts/examples.ts'
import { levelOf, outputNeuron } from '../parts/neurons.ts'
import { give } from '../parts/next.ts'

const type = 'ai_nn_output_node_sound'

/** A tone of value × 5 Hz while the value is above 0; of several the highest sounds. */
export const ai_nn_output_node_sound = outputNeuron({
  type,
  pack: 'core',
  uses: 'sound',
  fields: [],
  label: 'neuron.sound',
  colour: 'actuator',
  run: (_block, frame) => give({ order: 'sound', level: levelOf(frame) }),
  example: netProgram([distanceNeuron('2')], [{ type }]),
})
