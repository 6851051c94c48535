import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, plain, rows, worded, words } from '../parts/looks.ts'
import { fail } from '../parts/next.ts'
import type { Block, Definition, Face } from '../types.ts'
import { robSensors_colour_getSample } from './robSensors_colour_getSample.ts'
import { robSensors_compass_getSample } from './robSensors_compass_getSample.ts'
import { robSensors_encoder_getSample } from './robSensors_encoder_getSample.ts'
import { robSensors_gyro_getSample } from './robSensors_gyro_getSample.ts'
import { robSensors_htcolour_getSample } from './robSensors_htcolour_getSample.ts'
import { robSensors_infrared_getSample } from './robSensors_infrared_getSample.ts'
import { robSensors_irseeker_getSample } from './robSensors_irseeker_getSample.ts'
import { robSensors_key_getSample } from './robSensors_key_getSample.ts'
import { robSensors_sound_getSample } from './robSensors_sound_getSample.ts'
import { robSensors_timer_getSample } from './robSensors_timer_getSample.ts'
import { robSensors_touch_getSample } from './robSensors_touch_getSample.ts'
import { robSensors_ultrasonic_getSample } from './robSensors_ultrasonic_getSample.ts'

const type = 'robSensors_getSample'

interface Kind {
  readonly definition: Definition
  readonly mode: string
  readonly words: string
  readonly output: Face['output']
}

const kind = (
  definition: Definition,
  mode: string,
  words: string,
  output: Face['output'] = 'Number',
): Kind => ({ definition, mode, words, output })

/** SENSORTYPE is today's block and its MODE in one word. */
const kinds: ReadonlyMap<string, Kind> = new Map([
  ['TOUCH_PRESSED', kind(robSensors_touch_getSample, 'PRESSED', 'touchSensor', 'Boolean')],
  ['ULTRASONIC_DISTANCE', kind(robSensors_ultrasonic_getSample, 'DISTANCE', 'distance')],
  ['ULTRASONIC_PRESENCE', kind(robSensors_ultrasonic_getSample, 'PRESENCE', 'presence', 'Boolean')],
  ['COLOUR_COLOUR', kind(robSensors_colour_getSample, 'COLOUR', 'colour', 'Colour')],
  ['COLOUR_LIGHT', kind(robSensors_colour_getSample, 'LIGHT', 'light')],
  ['COLOUR_AMBIENTLIGHT', kind(robSensors_colour_getSample, 'AMBIENTLIGHT', 'ambientLight')],
  ['INFRARED_DISTANCE', kind(robSensors_infrared_getSample, 'DISTANCE', 'nearness')],
  ['INFRARED_PRESENCE', kind(robSensors_infrared_getSample, 'PRESENCE', 'presence', 'Boolean')],
  ['ENCODER_DEGREE', kind(robSensors_encoder_getSample, 'DEGREE', 'degrees')],
  ['ENCODER_ROTATION', kind(robSensors_encoder_getSample, 'ROTATION', 'turns')],
  ['ENCODER_DISTANCE', kind(robSensors_encoder_getSample, 'DISTANCE', 'centimetres')],
  ['KEY_PRESSED', kind(robSensors_key_getSample, 'PRESSED', 'keyPressed', 'Boolean')],
  ['GYRO_ANGLE', kind(robSensors_gyro_getSample, 'ANGLE', 'angle')],
  ['GYRO_RATE', kind(robSensors_gyro_getSample, 'RATE', 'rate')],
  ['TIMER_VALUE', kind(robSensors_timer_getSample, 'VALUE', 'timer')],
  ['TIME', kind(robSensors_timer_getSample, 'VALUE', 'timer')],
  ['SOUND_SOUND', kind(robSensors_sound_getSample, 'SOUND', 'loudness')],
  ['COMPASS_ANGLE', kind(robSensors_compass_getSample, 'ANGLE', 'fromNorth')],
  ['COMPASS_COMPASS', kind(robSensors_compass_getSample, 'COMPASS', 'direction')],
  ['IRSEEKER_MODULATED', kind(robSensors_irseeker_getSample, 'MODULATED', 'modulated')],
  ['IRSEEKER_UNMODULATED', kind(robSensors_irseeker_getSample, 'UNMODULATED', 'unmodulated')],
  ['HTCOLOUR_COLOUR', kind(robSensors_htcolour_getSample, 'COLOUR', 'colour', 'Colour')],
  ['HTCOLOUR_LIGHT', kind(robSensors_htcolour_getSample, 'LIGHT', 'light')],
  ['HTCOLOUR_AMBIENTLIGHT', kind(robSensors_htcolour_getSample, 'AMBIENTLIGHT', 'ambientLight')],
])

const ports = ['1', '2', '3', '4', '5', 'A', 'B', 'C', 'D']
const keys = ['ENTER', 'UP', 'DOWN', 'LEFT', 'RIGHT', 'ESCAPE', 'ANY']

const kindOf = (block: Block) => kinds.get(field(block, 'SENSORTYPE', 'TOUCH_PRESSED'))

/** The block of today that means the same. */
function today(block: Block, { definition, mode }: Kind): Block {
  const fields = { ...block.fields, MODE: mode }
  return { ...block, type: definition.type, fields, mutation: { attrs: { mode } } }
}

/** An old block: SENSORTYPE and mutation `input` say which sensor, SENSORPORT where (a port, a motor, a timer, a key). */
export const robSensors_getSample: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Boolean',
    fields: [
      choice(
        'SENSORTYPE',
        [...kinds].map(([name, { words }]) => worded(name, words)),
      ),
      choice('SENSORPORT', [...ports, ...keys].map(plain)),
      hidden('SLOT'),
    ],
    inputs: [],
    mutation: { input: { field: 'SENSORTYPE' } },
    faces: {
      by: { field: 'SENSORTYPE' },
      of: Object.fromEntries([...kinds].map(([name, { output }]) => [name, { output }])),
    },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  check(block, context) {
    const found = kindOf(block)
    return found?.definition.check?.(today(block, found), context) ?? []
  },
  run(block, frame, context) {
    const found = kindOf(block)
    return found ? found.definition.run(today(block, found), frame, context) : fail('unknownChoice')
  },
  python: (py) => {
    const found = kindOf(py.block)
    return found ? py.as(today(py.block, found)) : py.gap('problem.unknownChoice')
  },
  example: [
    start,
    forever(
      show({
        type,
        mutation: { attrs: { input: 'ULTRASONIC_DISTANCE' } },
        fields: { SENSORTYPE: 'ULTRASONIC_DISTANCE', SENSORPORT: '2', SLOT: '' },
      }),
    ),
  ],
}
