import type { ReadMode } from '@botgarten/simulation'
import { motorNeuron, netProgram } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { inputNeuron } from '../parts/neurons.ts'

const type = 'ai_nn_input_node_coloursensor_rgb_channel'

const channels: ReadonlyMap<string, ReadMode> = new Map([
  ['#FF0000', 'red'],
  ['#00FF00', 'green'],
  ['#0000FF', 'blue'],
])

const channel = choice('COLOUR', [
  worded('#FF0000', 'red', '#FF0000'),
  worded('#00FF00', 'green', '#00FF00'),
  worded('#0000FF', 'blue', '#0000FF'),
])

/** How much red, green or blue is in the floor's colour: 0..255 as 0..100. */
export const ai_nn_input_node_coloursensor_rgb_channel = inputNeuron({
  type,
  pack: 'core',
  sensor: 'colour',
  port: 'SENSORPORT',
  fields: [channel, sensorPort('1')],
  label: 'neuron.channel',
  colour: { field: 'COLOUR' },
  mode: (block) => channels.get(field(block, 'COLOUR').toUpperCase()) ?? 'red',
  level: (part) => (Number(part) * 100) / 255,
  example: netProgram([{ type, fields: { COLOUR: '#FF0000', SENSORPORT: '1' } }], [motorNeuron('C')]),
})
