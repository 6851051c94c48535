import { missing } from '../parts/python.ts'
import { forever, show, start } from '../parts/examples.ts'
import { field, sensorPortIn } from '../parts/fields.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { sensorAtPort } from '../parts/sensors.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_compass_getSample'

/** From 0..360 to −180..180. */
const fromNorth = (degrees: number) => (degrees > 180 ? degrees - 360 : degrees)

/** MODE COMPASS: direction in degrees clockwise, 0..360, 0 = up · MODE ANGLE: the same from −180 to 180. */
export const robSensors_compass_getSample: Definition = {
  pack: 'core',
  ...sample(
    type,
    choice('MODE', [worded('COMPASS', 'direction'), worded('ANGLE', 'fromNorth')]),
    sensorPort('1'),
  ),
  check: sensorAtPort('compass', 'SENSORPORT'),
  run(block, _frame, { robot }) {
    const port = sensorPortIn(block, 'SENSORPORT')
    const degrees = port === undefined ? null : robot.read(port, 'compass')
    if (degrees === null) return fail('nothingToRead')
    return give(field(block, 'MODE', 'COMPASS') === 'ANGLE' ? fromNorth(Number(degrees)) : degrees)
  },
  python: missing('compass'),
  example: [start, forever(show(reading(type, 'COMPASS', '1')))],
}
