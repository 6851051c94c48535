// Does the server believe its clock? A pure function; the database stores its result.

/** Days by which the clock may be ahead of the last day of running without a doubt. */
const usual = 7
/** Without an answer of the operator the clock is believed on this many different days of running. */
const patience = 14
const year = 365
/** A server of this version cannot run before it: a clock without a battery starts in 1970. */
const earliest = '2026-01-01'

/** Days are ISO days at the place of the server: `2026-11-24`. */
export interface RunningDays {
  /** The last day of running by a clock that was believed; null before the first one. */
  readonly last: string | null
  readonly doubt: Doubt | null
}

interface Doubt {
  /** Different days of running since, as far as they may be right, in their order. */
  readonly days: readonly string[]
  /** The day of the clock at the last check. */
  readonly seen: string
  /** The operator has answered that the clock is wrong. */
  readonly denied: boolean
}

/** The ISO day `offset` days after today by the clock. */
export type Clock = (offset: number) => string

export const neverRun: RunningDays = { last: null, doubt: null }

/** Is today a day from this one on, at most `most` days later? */
const follows = (clock: Clock, day: string, most: number) => day <= clock(0) && day >= clock(-most)

const isBelieved = (last: string | null, clock: Clock) =>
  last === null ? clock(0) >= earliest : follows(clock, last, usual)

/** The state after a check of the clock. A second check on the same day changes nothing. */
export function afterCheck({ last, doubt }: RunningDays, clock: Clock): RunningDays {
  const today = clock(0)
  if (isBelieved(last, clock)) return { last: today, doubt: null }
  // The answer was about another clock once it jumps.
  if (doubt?.denied && follows(clock, doubt.seen, usual)) return { last, doubt: { ...doubt, seen: today } }
  const before = doubt?.days ?? []
  const isPossible = last !== null && follows(clock, last, year)
  // If today is right, a later day never was.
  const days = isPossible ? [...before.filter((day) => day < today), today] : before
  if (isPossible && days.length >= patience) return { last: today, doubt: null }
  return { last, doubt: { days, seen: today, denied: false } }
}

/** The state after the operator has answered whether the clock is right. Without a doubt there is no question. */
export function afterAnswer(state: RunningDays, clock: Clock, isRight: boolean): RunningDays {
  const { last, doubt } = state
  if (doubt === null) return state
  if (isRight) return { last: clock(0), doubt: null }
  return { last, doubt: { days: [], seen: clock(0), denied: true } }
}
