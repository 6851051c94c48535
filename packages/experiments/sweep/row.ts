import {
  greedyPath,
  createLearner,
  layOutWorld,
  learnedPath,
  learnWatching,
  planOf,
  shortestPath,
  type QLearner,
  type Plan,
  type Settings,
  type Task,
} from '@botgarten/learning/q-learning'
import { stream } from '@botgarten/numbers'
import { learnerSettings, nameOf, type Setting } from './settings.ts'

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
  /** Runs that had learned a way at the end or, where moves are by chance, a plan. */
  readonly learnedAtEnd: number
  /** Where moves are by chance: what the plans at the end may expect, their mean, and the largest any plan may. */
  readonly meanReturn?: number | null
  readonly bestReturn?: number | null
}

/** Executes all runs of one setting: the same numbers in whatever thread, order or shard. */
export function rowOf(job: Job, setting: Setting): Row {
  const world = layOutWorld(job.task)
  const settings = learnerSettings(setting, job)
  const shortest = shortestPath(world)
  const firsts: number[] = []
  const plans: Plan[] = []
  let [shortestAtEnd, anyAtEnd, learnedAtEnd] = [0, 0, 0]
  for (let run = 1; run <= job.runs; run++) {
    const learner = createLearner(world, settings, stream(job.seed, `learn/${nameOf(setting)}/${run}`))
    firsts.push(learnWatching(learner, job.moves, job.episodes) ?? Infinity)
    const way = greedyPath(learner).states
    if (way !== null) anyAtEnd++
    if (way !== null && way.length === shortest) shortestAtEnd++
    const { isLearned, plan } = judge(learner)
    if (isLearned) learnedAtEnd++
    if (plan) plans.push(plan)
  }
  const found = firsts.filter((first) => first < Infinity)
  return {
    ...setting,
    ...{ runs: job.runs, foundShortest: found.length, shortestAtEnd, anyAtEnd },
    medianFirst: finite(medianOf(firsts)),
    meanFirst: found.length === 0 ? null : meanOf(found),
    learnedAtEnd,
    ...(world.isSlippery && {
      meanReturn: meanOf(plans.map(({ expected }) => expected ?? -Infinity)),
      bestReturn: plans[0]?.best ?? null,
    }),
  }
}

function judge(learner: QLearner) {
  const way = learnedPath(learner)
  const plan = learner.world.isSlippery ? planOf(learner) : null
  const isLearned = way.states !== null || (plan?.doubt === null && learner.goals > 0)
  return { isLearned, plan }
}

function meanOf(values: readonly number[]): number | null {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length
  return Number.isFinite(mean) ? mean : null
}

function medianOf(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b)
  const middle = sorted.length / 2
  return (sorted[Math.ceil(middle) - 1]! + sorted[Math.floor(middle)]!) / 2
}

const finite = (value: number) => (value < Infinity ? value : null)
