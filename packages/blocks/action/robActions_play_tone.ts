import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking, waiting } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_play_tone'

export const robActions_play_tone: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [],
    inputs: [value('FREQUENCE', 'Number'), value('DURATION', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  uses: 'sound',
  /** The next block waits until the tone is over, as on the real robot. */
  run: afterAsking([ask('FREQUENCE'), ask('DURATION')], (frame, context) => {
    const frequency = Math.max(0, numberAt(frame, 0))
    const milliseconds = Math.max(0, numberAt(frame, 1))
    if (frame.counter === undefined && milliseconds > 0) context.robot.tone(frequency, milliseconds / 1000)
    return waiting(frame, context, milliseconds)
  }),
  python: (py) => py.line(py.robot.tone(py.value('FREQUENCE'), py.value('DURATION'))),
  example: [start, { type, values: { FREQUENCE: number(300), DURATION: number(100) } }],
}
