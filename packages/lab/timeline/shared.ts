import type { ObstacleState } from '@botgarten/simulation'
import type { Moment } from './moment.ts'

/** The same moment; what stands where it stood in the moment before is written down once for both. */
export function shared(moment: Moment, before: Moment | null): Moment {
  if (!before) return moment
  const were = before.simulation.obstacles
  const are = moment.simulation.obstacles.map((thing, index) =>
    same(thing, were[index]) ? were[index]! : thing,
  )
  const obstacles =
    are.length === were.length && are.every((thing, index) => thing === were[index]) ? were : are
  return { ...moment, simulation: { ...moment.simulation, obstacles } }
}

const same = (a: ObstacleState, b: ObstacleState | undefined) =>
  b !== undefined &&
  a.id === b.id &&
  Object.is(a.x, b.x) &&
  Object.is(a.y, b.y) &&
  Object.is(a.heading, b.heading) &&
  Object.is(a.vx, b.vx) &&
  Object.is(a.vy, b.vy) &&
  Object.is(a.spin, b.spin)
