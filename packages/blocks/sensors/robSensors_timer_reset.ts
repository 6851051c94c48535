import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { hidden, rows, timerNumber, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_timer_reset'

/** A timer counts from 0 again. */
export const robSensors_timer_reset: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'sensors',
    shape: 'statement',
    fields: [timerNumber, hidden('SLOT')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    const number = Number(field(block, 'SENSORPORT', '1'))
    if (robot.timer(number) === null) return fail('unknownChoice')
    robot.resetTimer(number)
    return done
  },
  python: (py) => py.line(py.robot.resetTimer(py.field('SENSORPORT', '1'))),
  example: [
    start,
    { type, fields: { SENSORPORT: '1', SLOT: '' } },
    forever(
      show({
        type: 'robSensors_timer_getSample',
        fields: { MODE: 'VALUE', SENSORPORT: '1', SLOT: '' },
      }),
    ),
  ],
}
