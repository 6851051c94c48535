import { along } from '../parts/python.ts'
import { side, speedOf } from '../parts/driving.ts'
import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking, moving } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_turn_for'

export const robActions_motorDiff_turn_for: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [side],
    inputs: [value('POWER', 'Number'), value('DEGREE', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER'), ask('DEGREE')], (frame, context, block) => {
    const degrees = numberAt(frame, 1)
    const speed = degrees < 0 ? 0 - speedOf(frame, block) : speedOf(frame, block)
    const { trackWidth, wheelDiameter } = context.robot
    // On the spot each wheel runs on a circle as wide as the track.
    const turning = (Math.abs(degrees) * trackWidth) / wheelDiameter
    return moving(frame, context, speed, 0 - speed, turning)
  }),
  python: (py) => py.line(py.robot.turn(along(py, 'POWER'), py.value('DEGREE'))),
  example: [
    start,
    { type, fields: { DIRECTION: 'RIGHT' }, values: { POWER: number(30), DEGREE: number(20) } },
  ],
}
