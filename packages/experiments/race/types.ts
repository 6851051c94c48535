import type { LearnedPath, Task } from '@botgarten/learning/q-learning'

/** Who races: Q-learning, SARSA, one that throws dice at every move, and one that always takes what is best so far. */
export const racers = ['q', 'sarsa', 'best', 'random'] as const
export type Racer = (typeof racers)[number]

/** A racer with its setting, each 0..1 (settings of the learner, model.md). `rho` counts for `q` and `sarsa` alone. */
export interface Lane {
  readonly racer: Racer
  readonly alpha: number
  readonly gamma: number
  readonly nu: number
  readonly rho: number
}

/** What wins, chosen before: fewest moves to the first good way, most stars (reward), fewest falls. */
export const criteria = ['way', 'stars', 'falls'] as const
export type Criterion = (typeof criteria)[number]

/** Plain data: it goes to other threads. */
export interface Race {
  readonly task: Task
  readonly lanes: readonly Lane[]
  /** Of each learner in each run. */
  readonly tries: number
  readonly runs: number
  readonly seed: number
  /** All lanes throw the dice of the first one. */
  readonly sameDice?: boolean
}

/** How many learners race; more tries and runs than a curve could show. */
export const limits = { lanes: { least: 2, most: 8 }, tries: 10_000, runs: 100 } as const

/** What a learner would do after so many tries: a way that it has learned, or why there is none. */
export type WayThen = { readonly states: readonly number[] } | { readonly reason: LearnedPath['reason'] }

/** One run of one lane, at every point of the curves (`pointsOf`). */
export interface RunRecord {
  /** Since the beginning. */
  readonly moves: readonly number[]
  readonly stars: readonly number[]
  readonly falls: readonly number[]
  readonly ways: readonly WayThen[]
  /** Moves until the end of the first try after which its learned way was a shortest one; null: it never was. */
  readonly first: number | null
  /** Where moves are by chance: how probably it gets to the goal by what it has learned at the end. */
  readonly reaches: number | null
}

/** Quartiles and median of all runs. */
export interface Band {
  readonly low: number
  readonly middle: number
  readonly high: number
}

/** `moves`, `stars`, `falls`: since the beginning. `pace`: moves a try, of the tries since the point before. */
export type Series = 'moves' | 'stars' | 'falls' | 'pace'

export interface LaneResult {
  readonly runs: number
  readonly curves: { readonly [series in Series]: readonly Band[] }
  /** By point: the ways of all runs, the most frequent first. */
  readonly ways: readonly (readonly (WayThen & { readonly runs: number })[])[]
  readonly bill: Bill
}

/** What a lane has used at the end: medians of its runs. */
export interface Bill {
  readonly tries: number
  readonly moves: number
  readonly stars: number
  readonly falls: number
  /** Null: not half of the runs found a shortest way. */
  readonly first: number | null
  /** Runs that found one. */
  readonly found: number
  readonly reaches: number | null
}
