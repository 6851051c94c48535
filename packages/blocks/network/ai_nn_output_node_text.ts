import { distanceNeuron, netProgram } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { levelOf, outputNeuron } from '../parts/neurons.ts'
import { give } from '../parts/next.ts'

const type = 'ai_nn_output_node_text'

/** A word on the display while the value is above 0; each text neuron has its own row. */
export const ai_nn_output_node_text = outputNeuron({
  type,
  pack: 'core',
  uses: 'display',
  fields: [{ name: 'OUTPUTNODE', kind: 'text', preset: '' }],
  label: 'neuron.text',
  colour: 'actuator',
  run: (block, frame) => give({ order: 'text', text: field(block, 'OUTPUTNODE'), level: levelOf(frame) }),
  example: netProgram([distanceNeuron('2')], [{ type, fields: { OUTPUTNODE: 'Bo' } }]),
})
