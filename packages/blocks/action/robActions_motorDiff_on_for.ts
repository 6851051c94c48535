import { along } from '../parts/python.ts'
import { direction, speedOf } from '../parts/driving.ts'
import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking, moving, wheelDegrees } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_on_for'

export const robActions_motorDiff_on_for: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [direction('BACKWARDS')],
    inputs: [value('POWER', 'Number'), value('DISTANCE', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER'), ask('DISTANCE')], (frame, context, block) => {
    const distance = numberAt(frame, 1)
    const speed = distance < 0 ? 0 - speedOf(frame, block) : speedOf(frame, block)
    return moving(frame, context, speed, speed, wheelDegrees(distance, context.robot.wheelDiameter))
  }),
  python: (py) => py.line(py.robot.straight(along(py, 'POWER'), py.value('DISTANCE'))),
  example: [
    start,
    { type, fields: { DIRECTION: 'FOREWARD' }, values: { POWER: number(30), DISTANCE: number(20) } },
  ],
}
