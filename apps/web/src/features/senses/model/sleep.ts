import { beginNight, learnedOf } from '@botgarten/lab/trying'
import type { Minute, TableBrain, Trial } from '@botgarten/learning/q-senses'
import type { Floor, World } from '@botgarten/simulation'

/** What a robot is to learn while nobody looks. */
export interface Asked {
  readonly world: World
  readonly floor: Floor
  readonly trial: Trial
  /** Its index in the world; the others stand still. */
  readonly robot: number
  readonly ticks: number
}

export interface Report {
  /** Ticks that are over. */
  readonly total: number
  readonly curve: readonly Minute[]
  /** So far, those of the minute under way among them. */
  readonly bumps: number
  /** Tries in which it could not get away from where it began. */
  readonly stuck: number
  /** At the end: what was learned. */
  readonly table: TableBrain | null
}

/** Ticks between two looks at the clock. */
const slice = 300
/** Milliseconds between two reports. */
const between = 50

/** Tries as fast as it can, and reports at most 20 times a second. The same as in the lab, bit for bit. */
export function sleep(
  { world, floor, trial, robot, ticks }: Asked,
  post: (report: Report) => void,
  now: () => number,
): void {
  const night = beginNight(world, floor, trial, robot)
  const { state } = night
  const report = (table: TableBrain | null) => {
    const { total, curve, minute, stuck } = state
    const bumps = curve.reduce((sum, one) => sum + one.bumps, minute.bumps)
    post({ total, curve, bumps, stuck, table })
  }
  let posted = now()
  while (state.total < ticks) {
    night.advance(Math.min(slice, ticks - state.total))
    if (now() - posted < between) continue
    report(null)
    posted = now()
  }
  report(learnedOf(state))
}
