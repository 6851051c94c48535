import type { Template } from '../types.ts'

/** What stands in the brackets of `ev3.…(…)`: a name, a number, or an expression. */
export interface RobotArgument {
  readonly word?: string
  readonly value: Template
}

type Make = (args: readonly RobotArgument[]) => Template | null

const word = (arg: RobotArgument | undefined): string => arg?.word ?? ''
const template = (arg: RobotArgument | undefined): Template | null => arg?.value ?? null

const sensor =
  (type: string, MODE: string): Make =>
  ([port]) => ({
    type,
    mutation: { attrs: { mode: MODE } },
    fields: { MODE, SENSORPORT: word(port).toUpperCase(), SLOT: '' },
  })

const modes: { readonly [word: string]: string } = {
  colour: 'COLOUR',
  color: 'COLOUR',
  light: 'LIGHT',
  ambientlight: 'AMBIENTLIGHT',
  rgb: 'RGB',
}

const colour =
  (type: string): Make =>
  ([mode, port]) => {
    const MODE = modes[word(mode).toLowerCase()]
    return MODE === undefined ? null : sensor(type, MODE)(port ? [port] : [])
  }

const neuron =
  (type: string, ...names: readonly string[]): Make =>
  (args) => ({ type, fields: Object.fromEntries(names.map((name, k) => [name, word(args[k])])) })

const text = { TYPE: 'String', PROTOCOL: 'BLUETOOTH', CHANNEL: '-1' }
const textMutation = { attrs: { datatype: 'String' } }

/** What can be asked of the robot after `ev3.`, by Open Roberta's names. */
export const robotFunctions: ReadonlyMap<string, Make> = new Map<string, Make>([
  ['getSpeedMotor', ([port]) => ({ type: 'robActions_motor_getPower', fields: { MOTORPORT: word(port) } })],
  ['getVolume', () => ({ type: 'robActions_play_getVolume' })],
  ['touchSensor.isPressed', sensor('robSensors_touch_getSample', 'PRESSED')],
  ['ultrasonicSensor.getDistance', sensor('robSensors_ultrasonic_getSample', 'DISTANCE')],
  ['ultrasonicSensor.getPresence', sensor('robSensors_ultrasonic_getSample', 'PRESENCE')],
  ['colorSensor', colour('robSensors_colour_getSample')],
  ['infraredSensor.getDistance', sensor('robSensors_infrared_getSample', 'DISTANCE')],
  ['infraredSensor.getPresence', sensor('robSensors_infrared_getSample', 'PRESENCE')],
  ['encoderSensor.getDegree', sensor('robSensors_encoder_getSample', 'DEGREE')],
  ['encoderSensor.getRotation', sensor('robSensors_encoder_getSample', 'ROTATION')],
  ['encoderSensor.getDistance', sensor('robSensors_encoder_getSample', 'DISTANCE')],
  ['keysSensor.isPressed', sensor('robSensors_key_getSample', 'PRESSED')],
  ['gyroSensor.getAngle', sensor('robSensors_gyro_getSample', 'ANGLE')],
  ['gyroSensor.getRate', sensor('robSensors_gyro_getSample', 'RATE')],
  ['timerSensor', sensor('robSensors_timer_getSample', 'VALUE')],
  ['soundSensor.getSoundLevel', sensor('robSensors_sound_getSample', 'SOUND')],
  ['hiTechColorSensor', colour('robSensors_htcolour_getSample')],
  ['hiTechInfraredSensor.getModulated', sensor('robSensors_irseeker_getSample', 'MODULATED')],
  ['hiTechInfraredSensor.getUnmodulated', sensor('robSensors_irseeker_getSample', 'UNMODULATED')],
  ['hiTechCompassSensor.getAngle', sensor('robSensors_compass_getSample', 'ANGLE')],
  ['hiTechCompassSensor.getCompass', sensor('robSensors_compass_getSample', 'COMPASS')],
  [
    'connectToRobot',
    ([name]) => {
      const ADDRESS = template(name)
      return ADDRESS && { type: 'robCommunication_startConnection', values: { ADDRESS } }
    },
  ],
  [
    'receiveMessage',
    ([connection]) => {
      const CONNECTION = template(connection)
      if (!CONNECTION) return null
      return {
        type: 'robCommunication_receiveBlock',
        mutation: textMutation,
        fields: text,
        values: { CONNECTION },
      }
    },
  ],
  ['waitForConnection', () => ({ type: 'robCommunication_waitForConnection' })],
  ['getOutputNeuron', neuron('robSensors_get_outputneuron_val', 'NAME')],
  ['getWeight', neuron('robSensors_get_weight', 'FROM', 'TO')],
  ['getBias', neuron('robSensors_get_bias', 'NAME')],
])
