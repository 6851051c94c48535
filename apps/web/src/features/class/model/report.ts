// What a page reports of itself: numbers that a teacher's page draws from, never a picture of the screen.
import type { View } from '@botgarten/lab'
import type { Here } from '@botgarten/classroom/tiles'
import { idInClass } from './sending.ts'

/** So many points of the trail are sent, five a second: whole cm, less than 2 kB. */
const longestTrail = 160
const every = 2

/** But for how long nothing was changed. */
export type Report = Omit<Here, 'idle'>

/** A pupil who is in the class and in no lab. */
export const nowhere: Report = {
  ...{ card: null, project: null, checks: [], failed: 0, running: false },
  ...{ size: null, pose: null, trail: [] },
}

export interface AtWork {
  /** Null: the free lab. */
  readonly card: string | null
  /** Id of the project on the device. */
  readonly project: string
  /** Ids of the card's checks. */
  readonly checks: readonly string[]
  /** Id of the check that the last run has missed first; null while a run is on, and after an edit. */
  readonly missed: string | null
  /** So many runs in a row have missed the same check. */
  readonly failed: number
  /** Of the world, cm. */
  readonly size: { readonly width: number; readonly height: number }
  readonly view: Pick<View, 'phase' | 'checks' | 'robots'>
}

export function reportOf({ card, project, checks, missed, failed, size, view }: AtWork): Report {
  const passed = new Set(view.checks.filter((check) => check.passed).map(({ id }) => id))
  const bo = view.robots[0]
  return {
    ...{ card, project: idInClass(project), failed, running: view.phase === 'running' },
    checks: checks.map((id) => (passed.has(id) ? 'passed' : id === missed ? 'failed' : 'open')),
    size: [Math.round(size.width), Math.round(size.height)],
    pose: bo ? { x: bo.pose.x, y: bo.pose.y, heading: bo.pose.heading % 360 } : null,
    trail: trailOf(bo?.trail ?? []),
  }
}

type Point = { readonly x: number; readonly y: number }

/** The last part of a way, its end among it. */
export const trailOf = (points: readonly Point[]): number[] =>
  points
    .filter((_, at) => (points.length - 1 - at) % every === 0)
    .slice(-longestTrail)
    .flatMap(({ x, y }) => [Math.round(x), Math.round(y)])
