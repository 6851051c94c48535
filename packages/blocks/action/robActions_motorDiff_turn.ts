import { along } from '../parts/python.ts'
import { side, speedOf } from '../parts/driving.ts'
import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_turn'

export const robActions_motorDiff_turn: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [side],
    inputs: [value('POWER', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER')], (frame, { robot }, block) => {
    const speed = speedOf(frame, block)
    robot.move({ left: speed, right: 0 - speed })
    return done
  }),
  python: (py) => py.line(py.robot.spin(along(py, 'POWER'))),
  example: [
    start,
    { type, fields: { DIRECTION: 'RIGHT' }, values: { POWER: number(30) } },
    { type: 'robControls_wait_time', values: { WAIT: number(500) } },
  ],
}
