import { distanceNeuron, motorNeuron, network, number, start, text } from '../../parts/examples.ts'
import { withRest, type ToolboxCategory } from '../../toolbox.ts'
import type { BlockType } from '../packs.ts'
import type { Template } from '../../types.ts'
import { blocks } from './blocks.ts'

type Fields = { readonly [name: string]: string }

const block = (type: BlockType, fields: Fields = {}, values: Template['values'] = {}): Template => ({
  type,
  ...(Object.keys(fields).length > 0 ? { fields } : {}),
  ...(Object.keys(values).length > 0 ? { values } : {}),
})

const compare = block('logic_compare', { OP: 'LT' })

const control: readonly Template[] = [
  start,
  block('robControls_loopForever'),
  block('controls_repeat_ext', {}, { TIMES: number(10) }),
  block('robControls_wait_time', {}, { WAIT: number(500) }),
  block('robControls_if'),
  { ...block('robControls_ifElse'), mutation: { attrs: { else: '1' } } },
]

const action: readonly Template[] = [
  block('robActions_motorDiff_on', { DIRECTION: 'FOREWARD' }, { POWER: number(30) }),
  block(
    'robActions_motorDiff_on_for',
    { DIRECTION: 'FOREWARD' },
    { POWER: number(30), DISTANCE: number(20) },
  ),
  block('robActions_motorDiff_turn', { DIRECTION: 'RIGHT' }, { POWER: number(30) }),
  block('robActions_motorDiff_turn_for', { DIRECTION: 'RIGHT' }, { POWER: number(30), DEGREE: number(20) }),
  block('robActions_motorDiff_stop'),
  block('robActions_motor_on', { MOTORPORT: 'B' }, { POWER: number(30) }),
  block('robActions_display_text', {}, { OUT: text('Bo'), COL: number(0), ROW: number(0) }),
  block('robActions_display_clear'),
  block('actions_bricklight_on_ev3', { COLOUR: 'GREEN', MODE: 'ON' }),
  block('actions_bricklight_off_ev3', { MODE: 'OFF' }),
  block('robActions_play_tone', {}, { FREQUENCE: number(300), DURATION: number(100) }),
]

const colourSensor = (mode: 'COLOUR' | 'LIGHT'): Template => ({
  ...block('robSensors_colour_getSample', { MODE: mode, SENSORPORT: '1', SLOT: '' }),
  mutation: { attrs: { mode } },
})

/** A sensor block with its mode and port as Open Roberta's toolbox has them. */
const sensor = (type: BlockType, mode: string, port: string): Template => ({
  ...block(type, { MODE: mode, SENSORPORT: port, SLOT: '' }),
  mutation: { attrs: { mode } },
})

const sensors: readonly Template[] = [
  sensor('robSensors_touch_getSample', 'PRESSED', '1'),
  {
    ...block('robSensors_ultrasonic_getSample', { MODE: 'DISTANCE', SENSORPORT: '2', SLOT: '' }),
    mutation: { attrs: { mode: 'DISTANCE' } },
  },
  colourSensor('COLOUR'),
  colourSensor('LIGHT'),
  sensor('robSensors_infrared_getSample', 'DISTANCE', '4'),
  sensor('robSensors_encoder_getSample', 'DEGREE', 'B'),
  block('robSensors_encoder_reset', { SENSORPORT: 'B' }),
  sensor('robSensors_key_getSample', 'PRESSED', 'ENTER'),
  sensor('robSensors_gyro_getSample', 'ANGLE', '2'),
  block('robSensors_gyro_reset', { SENSORPORT: '2' }),
  sensor('robSensors_timer_getSample', 'VALUE', '1'),
  block('robSensors_timer_reset', { SENSORPORT: '1', SLOT: '' }),
  sensor('robSensors_sound_getSample', 'SOUND', '2'),
  sensor('robSensors_compass_getSample', 'COMPASS', '1'),
  sensor('robSensors_odometry_getSample', 'X', '4'),
  block('robColour_picker', { COLOUR: '#B30006' }),
]

const neurons: readonly Template[] = [
  network([distanceNeuron('2'), distanceNeuron('3')], [motorNeuron('C'), motorNeuron('B')]),
  distanceNeuron('2'),
  block('ai_nn_input_node_coloursensor_light', { SENSORPORT: '1' }),
  block('ai_nn_input_node_coloursensor_color', { COLOUR: '#00642E', SENSORPORT: '1' }),
  block('ai_nn_input_node_coloursensor_rgb_channel', { COLOUR: '#FF0000', SENSORPORT: '1' }),
  motorNeuron('C'),
  block('ai_nn_output_node_led', { OUTPUTNODE: '#00642E' }),
  block('ai_nn_output_node_text', { OUTPUTNODE: 'Bo' }),
  block('ai_nn_output_node_sound'),
  ...Object.values(network([distanceNeuron('2')], [motorNeuron('C')]).values ?? {}),
]

/** In order, with what is plugged in: presets of Open Roberta's beginner toolbox, our ports. */
const presets: readonly ToolboxCategory[] = [
  { category: 'control', blocks: control },
  { category: 'action', blocks: action },
  { category: 'sensors', blocks: sensors },
  { category: 'logic', blocks: [compare] },
  {
    category: 'math',
    blocks: [
      block('math_number', { NUM: '0' }),
      block('math_arithmetic', { OP: 'ADD' }, { A: number(1), B: number(1) }),
    ],
  },
  { category: 'text', blocks: [block('text', { TEXT: '' })] },
  { category: 'network', blocks: neurons },
]

export const coreToolbox = withRest(presets, blocks)

/** What a child finds: comparing is the one block of logic, and stands with what asks for it. */
export const plainToolbox: readonly ToolboxCategory[] = coreToolbox
  .filter(({ category }) => category !== 'logic')
  .map((row) => (row.category === 'control' ? { ...row, blocks: [...row.blocks, compare] } : row))
