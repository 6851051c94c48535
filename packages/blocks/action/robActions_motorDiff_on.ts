import { along } from '../parts/python.ts'
import { direction, speedOf } from '../parts/driving.ts'
import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_on'

export const robActions_motorDiff_on: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [direction('BACKWARD')],
    inputs: [value('POWER', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER')], (frame, { robot }, block) => {
    const speed = speedOf(frame, block)
    robot.move({ left: speed, right: speed })
    return done
  }),
  python: (py) => py.line(py.robot.forward(along(py, 'POWER'))),
  example: [
    start,
    { type, fields: { DIRECTION: 'FOREWARD' }, values: { POWER: number(30) } },
    { type: 'robControls_wait_time', values: { WAIT: number(500) } },
  ],
}
