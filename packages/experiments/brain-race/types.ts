import type { Document } from '@botgarten/lab'
import type { Floor, Pose, Seconds } from '@botgarten/simulation'
import type { Effort, Project } from '@botgarten/programs'
import type { LaneKind } from '@botgarten/programs/lanes'

export type { LaneKind } from '@botgarten/programs/lanes'

/**
 * What counts. `way`: cm a minute, with the bumps beside it · `laps`: gates passed in their order, as a part of a lap ·
 * `time`: seconds until the robot's front is so near to a thing, and all of them where it never is.
 */
export type Measure =
  | { readonly kind: 'way' }
  | { readonly kind: 'laps'; readonly gates: readonly Place[]; readonly cm: number }
  | { readonly kind: 'time'; readonly obstacle: string; readonly cm: number }

export interface Place {
  readonly x: number
  readonly y: number
}

/** Where brains race. */
export interface Course {
  readonly id: string
  /** Id of its world. */
  readonly world: string
  /** Start poses: the first `shown` are there to prepare on, the others are sealed until the race. */
  readonly starts: readonly Pose[]
  readonly shown: number
  /** Of a run from each start. */
  readonly seconds: Seconds
  readonly measure: Measure
}

/** A course with the world that it is in, as a document with one robot. */
export interface Ground {
  readonly course: Course
  readonly world: Document['world']
  readonly floor: Floor
}

/** A brain that races: a program with what it drives by and what went into it, as a project holds them. */
export type Racer = Pick<Project, 'programs' | 'brains' | 'tables'> & {
  /** As far as it is known. */
  readonly effort?: Partial<Effort>
}

/** What came of one start. */
export interface Run {
  /** Where it began: the start, or the nearest free place. */
  readonly from: Pose
  readonly moved: boolean
  /** Of the middle of the axle. */
  readonly cm: number
  readonly bumps: number
  /** Part of the time at a wall or a thing, 0..1. */
  readonly atWall: number
  /** Runs of a net, conditions asked, looks into a table. */
  readonly decisions: number
  /** What the course measures; 0 where nothing moved (for `time`: all of the seconds). */
  readonly score: number
  /** Ten places a second. */
  readonly trail: readonly Place[]
}

/** Why a brain does not race. `learns`: it would go on learning while it drives. */
export type NotReady = 'missing' | 'cannotRun' | 'learns'

/** A lane's results, start by start. */
export interface LaneResult {
  readonly kind: LaneKind
  /** Null: it was not ready. */
  readonly runs: readonly Run[] | null
  readonly problem: NotReady | null
}
