import { refuseLanes } from './refuse.ts'
import { resultOf } from './result.ts'
import { runLane } from './run.ts'
import type { LaneResult, Race } from './types.ts'

/** A part of a race: some runs of one lane, both counted from 1. */
export interface Heat {
  readonly lane: number
  readonly runs: readonly number[]
}

/** Runs of a heat: small enough to be shared well. */
const RUNS = 5

/** A race in parts that threads share. Who explores most has most moves and comes first, so that nobody waits at the end. */
export function heatsOf({ lanes, runs }: Race): readonly Heat[] {
  const explores = ({ racer, rho }: Race['lanes'][number]) =>
    racer === 'random' ? 2 : racer === 'best' ? 0 : rho
  return lanes
    .map((lane, index) => ({ lane: index + 1, weight: explores(lane) }))
    .toSorted((a, b) => b.weight - a.weight)
    .flatMap(({ lane }) =>
      Array.from({ length: Math.ceil(runs / RUNS) }, (_, heat) => ({
        lane,
        runs: Array.from({ length: Math.min(RUNS, runs - heat * RUNS) }, (_, run) => heat * RUNS + run + 1),
      })),
    )
}

/**
 * The whole race in this thread.
 * @throws RangeError for too few or too many lanes, tries or runs, a setting outside 0..1, or a task that is none
 */
export function raceOf(race: Race): readonly LaneResult[] {
  refuseLanes(race)
  return race.lanes.map((_, index) =>
    resultOf(
      Array.from({ length: race.runs }, (_, run) => runLane(race, index + 1, run + 1)),
      race.tries,
    ),
  )
}
