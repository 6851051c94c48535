import type { Hash } from '@botgarten/numbers'
import type { Thread } from '@botgarten/programs'
import { degreesOf, type Pose, type SimulationState } from '@botgarten/simulation'
import type { Watch } from '../checks/checks.ts'
import type { Brains, NetRun } from '../robots/brains.ts'
import type { SchoolState } from '../recording/school.ts'
import type { DriveKey } from '../inputs/input.ts'
import type { Run } from '../run.ts'
import type { Tables, Trials } from '../trying/trials.ts'
import type { Timeline } from './timeline.ts'
import type { Track } from './tracks.ts'

/** Everything that decides how a run goes on, as plain data. */
export interface Moment {
  readonly tick: number
  /** How far this tick has come: steps of its programs from block to block, and inputs that were given. */
  readonly part: number
  readonly given: number
  readonly simulation: SimulationState
  readonly threads: readonly Thread[]
  readonly brains: Brains
  /** Start poses of the obstacles: a hand changes them. */
  readonly starts: { readonly [id: string]: Pose }
  /** By robot and network block. */
  readonly lastRuns: readonly (readonly (readonly [string, NetRun])[])[]
  readonly keys: readonly DriveKey[]
  /** Index of the robot that the keys drive. */
  readonly driven: number
  readonly school: SchoolState
  readonly trials: Trials['state']
  readonly tables: Tables
  readonly watches: readonly Watch[]
  readonly hash: Hash
  readonly endedAt: number | null
}

/** One course of time: enough to stand at its end and to go back in it. */
export interface Course {
  readonly timeline: Timeline<Moment>
  readonly tracks: readonly Track[]
  readonly now: Moment
}

/** Where a robot or a thing stands. */
export const poseIn = (
  thing: { readonly x: number; readonly y: number; readonly heading: number } | undefined,
) => (thing ? { x: thing.x, y: thing.y, heading: degreesOf(thing.heading) } : null)

/** The moment at which a run stands. */
export function momentOf(run: Run): Moment {
  const { tick, part, given, brains, starts, keys, driven, endedAt } = run
  return {
    ...{ tick, part, given, brains, starts, keys, driven, endedAt },
    simulation: run.simulation.keyframe(),
    threads: run.robots.map(({ thread }) => structuredClone(thread)),
    lastRuns: run.robots.map(({ brains }) => [...brains.lastRuns]),
    school: run.school.state,
    trials: structuredClone(run.trials.state),
    tables: run.trials.tables,
    watches: structuredClone(run.watches),
    hash: [...run.hash],
  }
}

/** Puts a run back, or forth, to a moment of it. */
export function restore(run: Run, moment: Moment): void {
  run.simulation.restore(moment.simulation)
  for (const [id, brain] of Object.entries(moment.brains)) if (run.brains[id] !== brain) run.use(id, brain)
  const { tick, part, given, brains, starts, keys, driven, endedAt } = moment
  Object.assign(run, { tick, part, given, brains, starts, keys, driven, endedAt } satisfies Partial<Run>)
  run.school.restore(moment.school)
  run.trials.state = structuredClone(moment.trials)
  run.trials.tables = moment.tables
  run.watches = structuredClone(moment.watches) as Watch[]
  run.hash = [...moment.hash]
  run.robots.forEach((robot, index) => {
    robot.thread = structuredClone(moment.threads[index]!)
    robot.brains.lastRuns.clear()
    for (const [id, last] of moment.lastRuns[index]!) robot.brains.lastRuns.set(id, last)
  })
}
