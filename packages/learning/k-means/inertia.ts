import { farIn, flat } from './distances.ts'
import type { KState, Points } from './types.ts'

/** What each group has in the last sum of distances: by group. Null: points are finding their centres just now. */
export function inertiaByGroup({ values, features }: Points, state: KState): number[] | null {
  const { phase, labels, before, distance } = state
  if (phase === 'assign') return null
  const all = flat(before)
  const sums = before.map(() => 0)
  labels.forEach((label, point) => {
    sums[label]! += farIn[distance](values, point * features, all, label * features, features)
  })
  return sums
}
