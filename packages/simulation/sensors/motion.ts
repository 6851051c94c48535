import type { Scene } from '../scene.ts'
import { TICKS_PER_SECOND } from '../time.ts'

/** Headings before a tick, by robot: what a gyro's rate is measured from. */
export type Headings = Float64Array

export function noteHeadings({ state }: Scene, headings: Headings): void {
  for (let robot = 0; robot < headings.length; robot++) headings[robot] = state.robots[robot]!.heading
}

/** After a tick: how fast each robot turns, and its timers a tick further. */
export function noteMotion({ state }: Scene, headings: Headings): void {
  for (let robot = 0; robot < headings.length; robot++) {
    const own = state.robots[robot]!
    own.spin = (own.heading - headings[robot]!) * TICKS_PER_SECOND
    for (let timer = 0; timer < own.timers.length; timer++) own.timers[timer]!++
  }
}
