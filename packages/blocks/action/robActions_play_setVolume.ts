import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { cut, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_play_setVolume'

/** 0 to 100. */
export const robActions_play_setVolume: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [],
    inputs: [value('VOLUME', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('VOLUME')], (frame, { robot }) => {
    robot.setVolume(cut(numberAt(frame, 0), 0, 100))
    return done
  }),
  python: (py) => py.line(py.robot.setVolume(py.value('VOLUME'))),
  example: [start, { type, values: { VOLUME: number(50) } }],
}
