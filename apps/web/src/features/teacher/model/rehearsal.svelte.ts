import * as v from 'valibot'
import { rehearsalOutcome, rehearsalProgress } from './answers.ts'
import type { ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'

export type Progress = v.InferOutput<typeof rehearsalProgress>
export type Outcome = v.InferOutput<typeof rehearsalOutcome>

/** A lesson as it is rehearsed: a class of the largest size, for a minute. */
export const lesson = { pupils: 35, seconds: 60 } as const

/** `broken`: it did not come to its end, by a cut connection or a full disk. */
export type RehearsalState = 'before' | 'playing' | 'stopped' | 'broken' | 'green' | 'red'

/** A lesson that the server plays with itself, as this page follows it. */
export class Rehearsal {
  readonly #api: ClassApi
  #state = $state<RehearsalState>('before')
  #progress = $state.raw<Progress | null>(null)
  #outcome = $state.raw<Outcome | null>(null)
  readonly #attempts = new Attempts()
  #stop = new AbortController()

  constructor(api: ClassApi) {
    this.#api = api
  }

  get state() {
    return this.#state
  }
  /** Null until the server has begun. */
  get progress() {
    return this.#progress
  }
  get outcome() {
    return this.#outcome
  }
  get refused() {
    return this.#attempts.refused
  }

  async play(): Promise<void> {
    if (this.#state === 'playing') return
    this.#state = 'playing'
    this.#progress = this.#outcome = null
    const stop = (this.#stop = new AbortController())
    await this.#attempts.do(() => this.#follow(stop.signal))
    // A page that stopped it knows already; what comes after is none of its business.
    if (this.#stop === stop && this.#state === 'playing')
      this.#state = this.refused === null ? 'broken' : 'before'
  }

  async #follow(signal: AbortSignal): Promise<void> {
    try {
      for await (const { event, data } of this.#api.events('/rehearsal', lesson, signal)) {
        if (event === 'progress') this.#progress = v.parse(rehearsalProgress, data)
        if (event !== 'done') continue
        this.#outcome = v.parse(rehearsalOutcome, data)
        this.#state = this.#outcome.green ? 'green' : 'red'
      }
    } catch (error) {
      if (!signal.aborted) throw error
    }
  }

  /** Ends it: its pupils and their work go at once. */
  stop(): void {
    if (this.#state === 'playing') this.#state = 'stopped'
    this.#stop.abort()
  }
}
