import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { hidden, timerNumber } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_timer_getSample'

/** Milliseconds since Start, or since this timer was set back. */
export const robSensors_timer_getSample: Definition = {
  pack: 'core',
  ...sample(type, hidden('MODE', 'VALUE'), timerNumber),
  run(block, _frame, { robot }) {
    const milliseconds = robot.timer(Number(field(block, 'SENSORPORT', '1')))
    return milliseconds === null ? fail('unknownChoice') : give(milliseconds)
  },
  python: (py) => py.robot.timer(py.field('SENSORPORT', '1')),
  example: [start, forever(show(reading(type, 'VALUE', '1')))],
}
