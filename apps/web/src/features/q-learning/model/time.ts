import type { Episode } from '@botgarten/learning/q-learning'

/** What a move shows, one after the other: where it is, what it decides, the ride, what it gets, which number changes. */
export const phases = ['here', 'decide', 'ride', 'reward', 'learn'] as const
export type Phase = (typeof phases)[number]

/** Milliseconds of a whole move at ×1. */
export const MOVE = 1000
/** Where each phase begins, as a share of the move. What it shows stays until the next move reaches the same phase. */
const begins: { readonly [phase in Phase]: number } = {
  here: 0,
  decide: 0.15,
  ride: 0.4,
  reward: 0.75,
  learn: 0.85,
}

/** The phase of a move at `progress`, 0..1. */
export const phaseAt = (progress: number): Phase =>
  phases.findLast((phase) => progress >= begins[phase]) ?? 'here'

/** Has a phase begun at `progress`? */
export const isReached = (phase: Phase, progress: number): boolean => progress >= begins[phase]

/** How far Bo is on the road, 0..1, gently in and out. */
export function rideAt(progress: number): number {
  const share = (progress - begins.ride) / (begins.reward - begins.ride)
  const x = Math.min(1, Math.max(0, share))
  return x * x * (3 - 2 * x)
}

/** A number that is learned on its way from before to after: it moves while the move learns, and is there at the end. */
export function movedTo(before: number, after: number, progress: number): number {
  const share = (progress - begins.learn) / (0.98 - begins.learn)
  return before + (after - before) * Math.min(1, Math.max(0, share))
}

/** Milliseconds from the move's beginning until a phase begins, and how long what it shows stays, at a speed. */
export const timesOf = (phase: Phase, speed: number) => ({
  begins: (begins[phase] * MOVE) / speed,
  stays: MOVE / speed,
})

// ---- tries on the timeline, and the clock ----

/** More than these are not told apart. */
const MOST = 20

/** The end of a try on the timeline. */
export interface Tick {
  /** Counted from 1. */
  readonly episode: number
  /** 0..1 of all moves. */
  readonly at: number
}

/** Where tries ended: each of them, or every second, fifth, tenth, so that there are at most twenty. */
export function ticksOf(episodes: readonly Pick<Episode, 'end'>[], made: number): readonly Tick[] {
  const step = stepFor(episodes.length)
  const count = Math.floor(episodes.length / step)
  return Array.from({ length: count }, (_, index) => {
    const episode = (index + 1) * step
    return { episode, at: episodes[episode - 1]!.end / Math.max(1, made) }
  })
}

/** 1, 2, 5, 10, 20, 50, … */
function stepFor(count: number): number {
  for (let ten = 1; ; ten *= 10)
    for (const step of [ten, 2 * ten, 5 * ten]) if (count <= MOST * step) return step
}

/** Above this limit (s) the tries end first: what is left of it says nothing. */
const MOST_LEFT = 1000

/** The clock of a learning: what is left of a short limit, else what has passed. A move is a second. */
export const timeShown = (
  limit: number,
  moves: number,
): { key: 'timeLeft' | 'timePassed'; seconds: number } =>
  limit > MOST_LEFT
    ? { key: 'timePassed', seconds: moves }
    : { key: 'timeLeft', seconds: Math.max(0, limit - moves) }
