import type { Signal } from './net.ts'
import { pulseRate, type Track } from './track.ts'

/** A link that a signal may be on. */
export interface Carrier {
  readonly id: string
  readonly track: Track
  /** Input × weight. */
  readonly signal: number
}

/** Longer than this (ms) nothing was painted: pulses go on from where they were. */
const longest = 100

/** Pulses under way: a signal that gets stronger makes them faster without a jump. */
export class Pulses {
  readonly #shares = new Map<string, number>()
  #at = 0

  /** @param now in ms, not before the last one */
  at(now: number, carriers: readonly Carrier[]): readonly Signal[] {
    const passed = now - this.#at > longest ? 0 : now - this.#at
    this.#at = now
    return carriers.map(({ id, track, signal }) => {
      const { count, milliseconds } = pulseRate(signal)
      const share = ((this.#shares.get(id) ?? 0) + passed / milliseconds) % 1
      this.#shares.set(id, share)
      return { track, count, share }
    })
  }
}
