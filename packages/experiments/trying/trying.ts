import { beginNight, rideBy, tableOf, ticksOf } from '@botgarten/lab/trying'
import type { Minute, TableBrain, Trial } from '@botgarten/learning/q-senses'
import type { Floor, World } from '@botgarten/simulation'

/** When a table counts as learned: so long from each start without a bump, and at least so many cm a minute. */
export interface Mark {
  readonly seconds: number
  readonly cm: number
}
export const mark: Mark = { seconds: 60, cm: 400 }

/** What came of a trial. */
export interface Tried {
  readonly table: TableBrain
  readonly curve: readonly Minute[]
  /** The first whole minute after which the frozen table passes from every start; null: none. */
  readonly first: number | null
  /** Does it still pass at the end? */
  readonly last: boolean
  /** Tries in which it never got away from its start. */
  readonly stuck: number
}

/** Does a table pass from where each of these worlds has its robot? */
export const passes = (
  table: TableBrain,
  worlds: readonly World[],
  floor: Floor,
  { seconds, cm }: Mark = mark,
) =>
  worlds.every((world) => {
    const ride = rideBy(table, world, floor, seconds, true)
    return ride.bumps === 0 && ride.cm >= cm
  })

/** Learns in the first of these worlds; judged after every whole minute until it passes, and at the end. */
export function tryOut(
  worlds: readonly World[],
  floor: Floor,
  trial: Trial,
  minutes: number,
  by: Mark = mark,
): Tried {
  const night = beginNight(worlds[0]!, floor, trial)
  let first: number | null = null
  let last = false
  for (let minute = 1; minute <= Math.ceil(minutes); minute++) {
    night.advance(ticksOf(Math.min(minute, minutes)) - night.state.total)
    if (first !== null && minute < minutes) continue
    last = passes(tableOf(night.state), worlds, floor, by)
    if (last) first ??= minute
  }
  const { curve, stuck } = night.state
  return { table: tableOf(night.state), curve, first, last, stuck }
}
