import type { Missing } from '@botgarten/lab'
import { distance } from '#figures/world/distance.ts'

/** Where the robot was, where it should have been (cm on the floor), and that distance in words; null if the miss names no point. */
export function gapOf({ gap }: Pick<Missing, 'gap'>) {
  if (!gap) return null
  const { from, to } = gap
  return { from, to, label: distance(Math.hypot(to.x - from.x, to.y - from.y)) }
}
