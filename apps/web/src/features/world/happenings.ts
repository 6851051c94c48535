import type { RobotView } from '@botgarten/lab'

/** What is worth a sentence to somebody who does not see the screen. */
export type Happening = 'bumped' | 'stopped'

// A robot slower than this (percent) stands, as for the cards' checks.
const standing = 3

const moves = ({ motors }: RobotView) => Object.values(motors).some((speed) => Math.abs(speed) >= standing)

/** Compares a robot with itself a while ago; null where nothing of meaning has changed. */
export function happening(before: RobotView | undefined, now: RobotView): Happening | null {
  if (!before) return null
  if (now.touching.length > 0 && before.touching.length === 0) return 'bumped'
  return moves(before) && !moves(now) ? 'stopped' : null
}
