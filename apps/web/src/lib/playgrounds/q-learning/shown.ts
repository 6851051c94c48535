import {
  policy,
  starsOf,
  visited,
  type BestWay,
  type Course,
  type QTrace,
  type QWorld,
} from '@botgarten/learning/q-learning'

/** What the screen shows of a course at the move that is shown. Made anew for every move, never written to. */
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
  readonly way: BestWay
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
  return {
    world: learner.world,
    ...{ t: course.shown, made: course.made, trace, over: course.over },
    episodes: course.episodes,
    episode: trace?.episode ?? learner.episodes + 1,
    q: learner.q.slice(),
    tries: learner.tries.slice(),
    visited: visited(learner),
    policy: policy(learner),
    way: course.way(),
    found: course.foundIn(),
    foundAt: course.foundAt(),
    stars: {
      before: trace ? starsOf(learner, trace.before) : 0,
      after: trace ? starsOf(learner, trace.after) : 0,
    },
  }
}
