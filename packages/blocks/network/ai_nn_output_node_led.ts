import type { LedColour } from '@botgarten/simulation'
import { distanceNeuron, netProgram } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, worded } from '../parts/looks.ts'
import { levelOf, outputNeuron } from '../parts/neurons.ts'
import { fail, give } from '../parts/next.ts'

const type = 'ai_nn_output_node_led'

const lamps: ReadonlyMap<string, LedColour> = new Map([
  ['#00642E', 'green'],
  ['#F7D118', 'orange'],
  ['#B30006', 'red'],
])

const lamp = choice('OUTPUTNODE', [
  worded('#00642E', 'green', '#00642E'),
  worded('#F7D118', 'orange', '#F7D118'),
  worded('#B30006', 'red', '#B30006'),
])

/** The lamp in this colour while the value is above 0; of several lamps the highest value wins. */
export const ai_nn_output_node_led = outputNeuron({
  type,
  pack: 'core',
  uses: 'lamp',
  fields: [lamp],
  label: 'neuron.lamp',
  colour: { field: 'OUTPUTNODE' },
  run(block, frame) {
    const colour = lamps.get(field(block, 'OUTPUTNODE', field(block, 'COLOUR')).toUpperCase())
    if (colour === undefined) return fail('unknownChoice')
    return give({ order: 'led', colour, level: levelOf(frame) })
  },
  example: netProgram([distanceNeuron('2')], [{ type, fields: { OUTPUTNODE: '#00642E' } }]),
})
