import { distanceNeuron, motorNeuron, netProgram } from '../parts/examples.ts'
import { motorPortIn } from '../parts/fields.ts'
import { choice, worded } from '../parts/looks.ts'
import { levelOf, outputNeuron } from '../parts/neurons.ts'
import { fail, give } from '../parts/next.ts'

const port = choice(
  'OUTPUTNODE',
  ['A', 'B', 'C', 'D'].map((port) => worded(`MOTORPORT_${port}`, `motor${port}`)),
  'MOTORPORT_C',
)

/** A motor's speed in percent, cut to −100..100. */
export const ai_nn_output_node = outputNeuron({
  type: 'ai_nn_output_node',
  pack: 'core',
  fields: [port],
  label: 'neuron.motor',
  port: 'OUTPUTNODE',
  colour: 'actuator',
  run(block, frame) {
    const port = motorPortIn(block, 'OUTPUTNODE')
    if (port === undefined) return fail('unknownChoice')
    return give({ order: 'motor', port, level: levelOf(frame) })
  },
  example: netProgram([distanceNeuron('2')], [motorNeuron('C')]),
})
