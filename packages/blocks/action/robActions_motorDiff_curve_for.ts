import { along } from '../parts/python.ts'
import { speedsOf } from '../parts/driving.ts'
import { direction } from '../parts/driving.ts'
import { number, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking, moving, wheelDegrees } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_curve_for'

/** How much farther the faster wheel goes than the middle of the robot. */
function share(left: number, right: number): number {
  const faster = Math.max(Math.abs(left), Math.abs(right))
  const middle = Math.abs(left + right) / 2
  return middle === 0 ? 1 : faster / middle
}

/** The middle of the robot goes DISTANCE along its curve. Nothing turns where both speeds are 0; on the spot it is the wheels that go so far. */
export const robActions_motorDiff_curve_for: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [direction('BACKWARDS')],
    inputs: [value('POWER_LEFT', 'Number'), value('POWER_RIGHT', 'Number'), value('DISTANCE', 'Number')],
    rows: rows(type, 3),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER_LEFT'), ask('POWER_RIGHT'), ask('DISTANCE')], (frame, context, block) => {
    const { left, right } = speedsOf(frame, block)
    const distance = numberAt(frame, 2)
    const sign = distance < 0 ? -1 : 1
    const degrees = wheelDegrees(distance, context.robot.wheelDiameter) * share(left, right)
    return moving(frame, context, 0 + left * sign + 0, 0 + right * sign + 0, degrees)
  }),
  python: (py) =>
    py.line(py.robot.curve(along(py, 'POWER_LEFT'), along(py, 'POWER_RIGHT'), py.value('DISTANCE'))),
  example: [
    start,
    {
      type,
      fields: { DIRECTION: 'FOREWARD' },
      values: { POWER_LEFT: number(10), POWER_RIGHT: number(30), DISTANCE: number(20) },
    },
  ],
}
