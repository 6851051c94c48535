import { assignAll } from './assign.ts'
import { moveAll } from './move.ts'
import { roundsOnPlane } from './on-plane.ts'
import type { Distance, Points, Rounds } from './types.ts'

/** Rounds over the same points, one after the other; no point has a group yet. */
export const roundsOver = (points: Points, groups: number, distance: Distance): Rounds =>
  distance === 'euclidean' && points.features === 2
    ? roundsOnPlane(points, groups)
    : roundsAnywhere(points, distance)

function roundsAnywhere(points: Points, distance: Distance): Rounds {
  const labels = new Int32Array(points.count).fill(-1)
  return {
    labels: () => labels,
    next(centres) {
      const before = labels.slice()
      const inertia = assignAll(points, centres, distance, labels)
      const changed = labels.some((label, point) => label !== before[point])
      return { inertia, changed, centres: moveAll(points, labels, centres, distance).centres }
    },
  }
}
