import type { World } from '@botgarten/simulation'
import { clamp, type Point } from '#drawing/points.ts'

/** A world of thousands of things is a picture of the first hundred. */
export const mostThings = 100

/** In cm: what a tile shows of a floor. */
const frame = { width: 190, height: 76 }

/** The thing that is nearest to a place; null on an empty floor. */
function nearest({ obstacles }: Pick<World, 'obstacles'>, { x, y }: Point): Point | null {
  const far = (pose: Point) => Math.hypot(pose.x - x, pose.y - y)
  return obstacles.reduce<Point | null>(
    (found, { pose }) => (found && far(found) <= far(pose) ? found : pose),
    null,
  )
}

/**
 * The part of a floor that shows Bo, and as much as it can of the thing beside it: a `viewBox` in cm, y down. Bo is always
 * well inside.
 */
export function frameOf(world: Pick<World, 'size' | 'obstacles'>, pose: Point): string {
  const thing = nearest(world, pose) ?? { x: world.size.width / 2, y: world.size.height / 2 }
  const x = pose.x + clamp((thing.x - pose.x) * 0.6, -frame.width * 0.33, frame.width * 0.33)
  const y = pose.y + clamp((thing.y - pose.y) * 0.6, -frame.height * 0.24, frame.height * 0.24)
  const [left, top] = [x - frame.width / 2, world.size.height - y - frame.height / 2]
  return [left, top, frame.width, frame.height].map((one) => Math.round(one * 10) / 10).join(' ')
}
