import {
  bestReturn,
  expectedReturn,
  greedyPath,
  planOf,
  policy,
  starsOf,
  visited,
  type Course,
  type LearnedPath,
  type Plan,
  type QTrace,
  type QWorld,
} from '@botgarten/learning/q-learning'

import { tieOn } from './rides.ts'

/** What the screen shows of a course at the move that is shown. Made again for every move, never written to. */
export interface Shown {
  readonly world: QWorld
  readonly t: number
  readonly made: number
  /** Counted from 1: the one that is on. */
  readonly episode: number
  readonly trace: QTrace | null
  readonly q: Float64Array
  readonly tries: Uint32Array
  readonly visited: readonly boolean[]
  /** By station the best move; −1: none. */
  readonly policy: readonly number[]
  readonly way: LearnedPath
  /** By the study's rules: the way that the first of equal roads gives where none is learned yet. */
  readonly firstOfEqual: readonly number[] | null
  /** Where moves are by chance: what Bo would do, and what that may expect. */
  readonly plan: Plan | null
  /** Bo goes in a circle, has learned to its end, and nothing else would pay more. */
  readonly isCircleBest: boolean
  /** Where several moves of the way are worth the same. */
  readonly tie: ReturnType<typeof tieOn>
  readonly found: number | null
  /** The move at which it was found. */
  readonly foundAt: number | null
  readonly over: Course['over']
  /** All tries that have ended, however far back the move is that is shown. */
  readonly episodes: Course['episodes']
  /** 0..5 of the move that was made: before and after. */
  readonly stars: { readonly before: number; readonly after: number }
}

export function shownOf(course: Course): Shown {
  const { learner, trace } = course
  const { world, settings } = learner
  const way = course.way()
  return {
    world,
    ...{ t: course.shown, made: course.made, trace, over: course.over },
    episodes: course.episodes,
    episode: trace?.episode ?? learner.episodes + 1,
    q: learner.q.slice(),
    tries: learner.tries.slice(),
    visited: visited(learner),
    policy: policy(learner),
    way,
    firstOfEqual: settings.rules === 'study' && !way.states ? greedyPath(learner).states : null,
    plan: world.isSlippery ? planOf(learner) : null,
    isCircleBest: course.over !== null && way.reason === 'circle' && isBest(learner),
    tie: way.states ? tieOn(course, way.states) : null,
    found: course.foundIn(),
    foundAt: course.foundAt(),
    stars: {
      before: trace ? starsOf(learner, trace.before) : 0,
      after: trace ? starsOf(learner, trace.after) : 0,
    },
  }
}

/** Is the learned policy worth as much from the start as the best one? */
function isBest(learner: Course['learner']): boolean {
  const { world, settings } = learner
  const best = bestReturn(world, settings.gamma)
  const expected = expectedReturn(world, policy(learner), settings.gamma)
  // Both are sums of the same rewards in another order.
  return best !== null && expected !== null && expected >= best - 1e-9 * Math.abs(best)
}

/** All actions of a station. */
export const actionsFrom = ({ first }: QWorld, station: number): readonly number[] =>
  Array.from({ length: first[station + 1]! - first[station]! }, (_, k) => first[station]! + k)

/** The moves of a station by where they lead. */
export function movesFrom({ first, meant }: QWorld, station: number): ReadonlyMap<number, number> {
  const [begin, end] = [first[station]!, first[station + 1]!]
  return new Map(Array.from(meant.subarray(begin, end), (to, index) => [to, begin + index]))
}

/** Of each station how many roads leave it, the closed ones too. */
export const roadCounts = (
  { states, first }: QWorld,
  closed: readonly (readonly [from: number, to: number])[],
): number[] =>
  Array.from({ length: states }, (_, station) => {
    const shut = closed.filter(([from]) => from === station).length
    return first[station + 1]! - first[station]! + shut
  })
