import type { TrainTrace } from '@botgarten/learning/neural-network/train'
import type { Example } from './messages.ts'
import type { Practice } from './practice.svelte.ts'

/** The seven beats of one example, in their order. */
export const beats = ['example', 'inputs', 'sums', 'says', 'error', 'arrows', 'knobs'] as const
export type Beat = (typeof beats)[number]

/** Milliseconds of a beat that plays by itself. */
const beatLength = 250
/** At the arrows there is most to see. */
const longBeat = 750

/** One example, opened step by step. */
export class Beats {
  readonly #practice: Practice
  #trace = $state.raw<TrainTrace | null>(null)
  #at = $state(0)
  #count = $state(0)
  #plays = $state(false)
  #timer: ReturnType<typeof setTimeout> | undefined
  /** The link whose arrow is explained: ids of its ends. */
  link = $state.raw<readonly [from: string, to: string] | null>(null)

  constructor(practice: Practice) {
    this.#practice = practice
  }

  /** null: none is open. */
  get trace() {
    return this.#trace
  }
  get beat(): Beat {
    return beats[this.#at]!
  }
  get at() {
    return this.#at
  }
  get plays() {
    return this.#plays
  }
  /** Has it come so far? */
  shows(beat: Beat): boolean {
    return this.#trace !== null && this.#at >= beats.indexOf(beat)
  }
  /** How many examples were taken since it was opened. */
  get count() {
    return this.#count
  }

  take({ trace, isPeek, now }: Example): void {
    this.#trace = trace
    if (isPeek) {
      this.#at = 0
      this.link = null
      return
    }
    this.#count++
    this.#practice.write(now)
  }

  /** The next beat; after the last one the next example. */
  next(): void {
    if (!this.#trace) return
    if (this.#at === beats.length - 1) return this.#practice.peek()
    this.#at++
    if (this.beat === 'knobs') this.#practice.take()
  }

  /** All examples by themselves, one a beat: slow motion. */
  play(on: boolean): void {
    clearTimeout(this.#timer)
    this.#plays = on
    if (!on) return
    const beat = this.beat === 'arrows' ? longBeat : beatLength
    this.#timer = setTimeout(() => {
      this.next()
      this.play(true)
    }, beat)
  }

  close(): void {
    if (!this.#trace) return
    this.play(false)
    this.#trace = null
    this.#at = 0
    this.#count = 0
    this.#practice.commit()
  }
}
