import { forever, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { hidden, rows, timerNumber, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_timer_getSample'

/** Milliseconds since Start, or since this timer was set back. */
export const robSensors_timer_getSample: Definition = {
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Number',
    fields: [hidden('MODE', 'VALUE'), timerNumber, hidden('SLOT')],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    const milliseconds = robot.timer(Number(field(block, 'SENSORPORT', '1')))
    return milliseconds === null ? fail('unknownChoice') : give(milliseconds)
  },
  example: [start, forever(show({ type, fields: { MODE: 'VALUE', SENSORPORT: '1', SLOT: '' } }))],
}
