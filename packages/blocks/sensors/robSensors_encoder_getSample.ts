import { motorIn } from '../parts/python.ts'
import { binds } from '../python.ts'
import { forever, number, show, start } from '../parts/examples.ts'
import { field, motorPortIn } from '../parts/fields.ts'
import { choice, encoderPort, worded } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_encoder_getSample'

/** From degrees of turning to what MODE asks for; DISTANCE: the way of a wheel on this motor in cm. */
const scales: ReadonlyMap<string, (degrees: number, wheelDiameter: number) => number> = new Map([
  ['DEGREE', (degrees) => degrees],
  ['ROTATION', (degrees) => degrees / 360],
  ['DISTANCE', (degrees, wheelDiameter) => (degrees / 360) * Math.PI * wheelDiameter],
])

/** How far a motor has turned since Start or since it was set back. */
export const robSensors_encoder_getSample: Definition = {
  pack: 'core',
  ...sample(
    type,
    choice('MODE', [
      worded('DEGREE', 'degrees'),
      worded('ROTATION', 'turns'),
      worded('DISTANCE', 'centimetres'),
    ]),
    encoderPort('B'),
  ),
  run(block, _frame, { robot }) {
    const port = motorPortIn(block, 'SENSORPORT')
    const scale = scales.get(field(block, 'MODE', 'DEGREE'))
    if (port === undefined || scale === undefined) return fail('unknownChoice')
    return give(scale(robot.encoder(port), robot.wheelDiameter))
  },
  python: (py) => {
    const turned = py.robot.encoder(motorIn(py, 'SENSORPORT'))
    const mode = py.field('MODE', 'DEGREE')
    if (mode === 'DEGREE') return turned
    return {
      code: mode === 'ROTATION' ? `${turned.code} / 360` : py.robot.way(turned.code),
      binds: binds.product,
    }
  },
  example: [
    start,
    { type: 'robActions_motor_on', fields: { MOTORPORT: 'B' }, values: { POWER: number(30) } },
    forever(show(reading(type, 'DEGREE', 'B'))),
  ],
}
