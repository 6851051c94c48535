import { colourField } from '../parts/colours.ts'
import { netProgram } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { sensorPort } from '../parts/looks.ts'
import { inputNeuron } from '../parts/neurons.ts'

const type = 'ai_nn_input_node_coloursensor_color'
const preset = '#00642E'

/** 100 where the sensor sees this one of the eight colours, else 0. */
export const ai_nn_input_node_coloursensor_color = inputNeuron({
  type,
  pack: 'core',
  sensor: 'colour',
  port: 'SENSORPORT',
  fields: [colourField(preset), sensorPort('1')],
  label: 'neuron.colour',
  colour: { field: 'COLOUR' },
  mode: 'colour',
  level: (seen, block) => (seen === field(block, 'COLOUR', preset).toUpperCase() ? 100 : 0),
  example: netProgram(
    [{ type, fields: { COLOUR: preset, SENSORPORT: '1' } }],
    [{ type: 'ai_nn_output_node_led', fields: { OUTPUTNODE: '#00642E' } }],
  ),
})
