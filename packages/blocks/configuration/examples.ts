import { forever, number, show, start } from '../parts/examples.ts'
import type { Template } from '../types.ts'

const motor = (side: string, reverse: string): Template => ({
  type: 'robBrick_motor_big',
  fields: { MOTOR_REGULATION: 'TRUE', MOTOR_REVERSE: reverse, MOTOR_DRIVE: side },
})

/** Large motors at B and C that drive the wheels. */
export const wheels = (reverse = 'OFF') => ({ MB: motor('RIGHT', reverse), MC: motor('LEFT', reverse) })

/** Start, then 20 cm ahead. */
export const drive: readonly Template[] = [
  start,
  {
    type: 'robActions_motorDiff_on_for',
    fields: { DIRECTION: 'FOREWARD' },
    values: { POWER: number(30), DISTANCE: number(20) },
  },
]

/** Start, then one turn of a motor. */
export const turn = (port: string): readonly Template[] => [
  start,
  {
    type: 'robActions_motor_on_for',
    fields: { MOTORPORT: port, MOTORROTATION: 'ROTATIONS' },
    values: { POWER: number(30), VALUE: number(1) },
  },
]

/** Its reading on the display, forever; the sensor sits at port 1. */
export const reading = (sensor: string, MODE: string) => ({
  plugged: { ...wheels(), S1: { type: `robBrick_${sensor}` } },
  program: [
    start,
    forever(
      show({
        type: `robSensors_${sensor}_getSample`,
        mutation: { attrs: { mode: MODE } },
        fields: { MODE, SENSORPORT: '1', SLOT: '' },
      }),
    ),
  ],
})
