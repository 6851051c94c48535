import { lerp } from './points.ts'

/** How the signal on a link is shown: `count` pulses on its length at a time, each `milliseconds` under way. */
export interface PulseRate {
  readonly count: 0 | 1 | 2 | 4 | 8
  readonly milliseconds: number
}

/**
 * Pulses for a signal (input × weight): 900 ms at 50, 1600 towards 0, 500 at 100, at most 8 at a time. Counts double, so
 * that pulses already under way stay where they are. Signals come in steps of 5, so that a trembling value changes nothing.
 */
export function pulseRate(signal: number): PulseRate {
  const strength = Math.min(100, Math.abs(signal))
  if (strength < 0.5) return { count: 0, milliseconds: 1600 }
  const step = Math.max(5, Math.round(strength / 5) * 5)
  const milliseconds = step <= 50 ? lerp(1600, 900, step / 50) : lerp(900, 500, (step - 50) / 50)
  return { count: step < 15 ? 1 : step < 35 ? 2 : step < 65 ? 4 : 8, milliseconds }
}
