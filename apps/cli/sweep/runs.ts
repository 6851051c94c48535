import {
  bestWay,
  createLearner,
  layOutWorld,
  learnWatching,
  shortestWay,
  type Settings,
  type Task,
} from '@botgarten/learning/q-learning'
import { stream } from '@botgarten/numbers'
import { learnerSettings, nameOf, type Setting } from './grid.ts'

/** What every run of a sweep shares. Plain data: it goes to other threads. */
export interface Job {
  readonly task: Task
  readonly rules: Settings['rules']
  readonly algorithm: Settings['algorithm']
  readonly moves: number
  readonly episodes: number
  readonly runs: number
  readonly seed: number
}

/** One setting of a job: what a thread is told. */
export interface Work {
  readonly job: Job
  readonly setting: Setting
}

/** A row: one setting, all its runs. Moves are counted from 1; null: no run, or not half of them, came so far. */
export interface Row extends Setting {
  readonly runs: number
  /** Runs in which the best way was a shortest one at some time, at the end, and in which there was any at the end. */
  readonly foundShortest: number
  readonly shortestAtEnd: number
  readonly anyAtEnd: number
  /** First move with a shortest way: the middle one of all runs, and the mean of those that found it. */
  readonly medianFirst: number | null
  readonly meanFirst: number | null
}

/** Carries out all runs of one setting: the same numbers in whatever thread, order or shard. */
export function rowOf(job: Job, setting: Setting): Row {
  const world = layOutWorld(job.task)
  const settings = learnerSettings(setting, job)
  const shortest = shortestWay(world)
  const firsts: number[] = []
  let [shortestAtEnd, anyAtEnd] = [0, 0]
  for (let run = 1; run <= job.runs; run++) {
    const learner = createLearner(world, settings, stream(job.seed, `learn/${nameOf(setting)}/${run}`))
    firsts.push(learnWatching(learner, job.moves, job.episodes) ?? Infinity)
    const way = bestWay(learner).stations
    if (way !== null) anyAtEnd++
    if (way !== null && way.length === shortest) shortestAtEnd++
  }
  const found = firsts.filter((first) => first < Infinity)
  return {
    ...setting,
    ...{ runs: job.runs, foundShortest: found.length, shortestAtEnd, anyAtEnd },
    medianFirst: finite(medianOf(firsts)),
    meanFirst: found.length === 0 ? null : found.reduce((sum, first) => sum + first, 0) / found.length,
  }
}

function medianOf(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b)
  const middle = sorted.length / 2
  return (sorted[Math.ceil(middle) - 1]! + sorted[Math.floor(middle)]!) / 2
}

const finite = (value: number) => (value < Infinity ? value : null)
