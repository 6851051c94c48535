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

/** Milliseconds from the move's beginning until a phase begins, and how long what it shows stays, at a speed. */
export const timesOf = (phase: Phase, speed: number) => ({
  begins: (begins[phase] * MOVE) / speed,
  stays: MOVE / speed,
})
