import { shortestPath, type QWorld } from '@botgarten/learning/q-learning'
import { resultOf, type LaneResult } from '@botgarten/experiments/race'

/** One try of the user: the stations it has visited, from the start on. */
export interface Tried {
  readonly states: readonly number[]
  readonly stars: number
  readonly falls: number
  readonly atGoal: boolean
}

export const movesOf = ({ states }: Tried): number => states.length - 1

/** The tries of the user as a lane with one run. Its learned way is that of the last try that reached the goal. */
export function resultOfWalk(tries: readonly Tried[], world: QWorld): LaneResult {
  const shortest = shortestPath(world)
  const sums = { moves: 0, stars: 0, falls: 0 }
  let first: number | null = null
  const points = tries.map((one, index) => {
    sums.moves += movesOf(one)
    sums.stars += one.stars
    sums.falls += one.falls
    if (one.atGoal && one.states.length === shortest) first ??= sums.moves
    const last = tries.slice(0, index + 1).findLast(({ atGoal }) => atGoal)
    return { ...sums, way: last ? { states: last.states } : { reason: 'neverReached' as const } }
  })
  return resultOf(
    [
      {
        moves: points.map(({ moves }) => moves),
        stars: points.map(({ stars }) => stars),
        falls: points.map(({ falls }) => falls),
        ways: points.map(({ way }) => way),
        ...{ first, reaches: null },
      },
    ],
    tries.length,
  )
}
