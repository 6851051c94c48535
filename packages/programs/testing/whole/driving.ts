import type { Block } from '@botgarten/blocks'
import { fieldOf, percent } from './parts.ts'
import type { Steps, WholeTwin } from './twin.ts'

/** Rule 8. */
const turned = (block: Block) => (/BACKWARD|LEFT/.test(fieldOf(block, 'DIRECTION')) ? -1 : 1)

/** Rule 9: so far with each wheel, and on when it has arrived. */
function* move(twin: WholeTwin, left: number, right: number, degrees: number): Steps<void> {
  const { robot } = twin.host
  if (degrees === 0 || (left === 0 && right === 0)) return robot.move({ left: 0, right: 0 })
  robot.move({ left: left + 0, right: right + 0, degrees })
  while (!robot.arrived()) yield 'tick'
}

export function* drive(twin: WholeTwin, block: Block): Steps<void> {
  const { robot } = twin.host
  const way = (cm: number) => (Math.abs(cm) / (Math.PI * robot.wheelDiameter)) * 360
  const sign = turned(block)
  const backward = (x: number) => (x < 0 ? -1 : 1)
  switch (block.type) {
    case 'robActions_motorDiff_on':
    case 'robActions_motorDiff_turn': {
      const left = percent(yield* twin.number(block, 'POWER')) * sign + 0
      return robot.move({ left, right: block.type.endsWith('turn') ? 0 - left : left })
    }
    case 'robActions_motorDiff_on_for': {
      const power = percent(yield* twin.number(block, 'POWER')) * sign
      const distance = yield* twin.number(block, 'DISTANCE')
      const speed = power * backward(distance)
      return yield* move(twin, speed, speed, way(distance))
    }
    case 'robActions_motorDiff_turn_for': {
      const power = percent(yield* twin.number(block, 'POWER')) * sign
      const angle = yield* twin.number(block, 'DEGREE')
      const speed = power * backward(angle)
      return yield* move(twin, speed, 0 - speed, (Math.abs(angle) * robot.trackWidth) / robot.wheelDiameter)
    }
    case 'robActions_motorDiff_curve': {
      const left = percent(yield* twin.number(block, 'POWER_LEFT')) * sign + 0
      return robot.move({ left, right: percent(yield* twin.number(block, 'POWER_RIGHT')) * sign + 0 })
    }
    default: {
      const left = percent(yield* twin.number(block, 'POWER_LEFT')) * sign
      const right = percent(yield* twin.number(block, 'POWER_RIGHT')) * sign
      const distance = yield* twin.number(block, 'DISTANCE')
      const middle = Math.abs(left + right) / 2
      const faster = middle === 0 ? 1 : Math.max(Math.abs(left), Math.abs(right)) / middle
      return yield* move(twin, left * backward(distance), right * backward(distance), way(distance) * faster)
    }
  }
}
