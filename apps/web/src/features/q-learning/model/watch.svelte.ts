import type { Course } from '@botgarten/learning/q-learning'
import { Clock } from './clock.ts'
import { ridesOf, type Ride } from './rides.ts'

/** Milliseconds of a move, of one ride and of many. */
const MOVE = { one: 700, many: 130 }

/** Bo walks on the map by its learned values, also where they lead in a circle or to no end. */
export class Watch {
  readonly #clock = new Clock((passed) => this.#turn(passed))
  #rides = $state.raw<readonly Ride[]>([])
  /** Which ride is on, and how far it is, in moves. */
  #ride = $state(0)
  #moved = $state(0)

  /** Is a ride shown, or has one been shown? */
  get on() {
    return this.#rides.length > 0
  }
  get count() {
    return this.#rides.length
  }
  get ride() {
    return this.#ride
  }
  get done() {
    return this.#ride >= this.#rides.length
  }
  /** How many of the rides so far have arrived. */
  readonly arrived = $derived.by(
    () => this.#rides.slice(0, this.#ride).filter(({ end }) => end === 'goal').length,
  )
  /** The shown move and how much of it has been animated, 0..1; after the end the last move stays. */
  readonly move = $derived.by(() => {
    const states = this.#rides[Math.min(this.#ride, this.#rides.length - 1)]?.states
    if (!states) return null
    const at = Math.min(Math.floor(this.#moved), states.length - 2)
    if (at < 0) return { from: states[0]!, to: states[0]!, share: 1 }
    return { from: states[at]!, to: states[at + 1]!, share: Math.min(1, this.#moved - at) }
  })

  start(course: Course, seed: number): void {
    this.#rides = ridesOf(course, seed)
    this.#ride = this.#moved = 0
    this.#clock.start()
  }

  stop(): void {
    this.#clock.stop()
    this.#rides = []
  }

  #turn(passed: number): void {
    this.#moved += passed / (this.count > 1 ? MOVE.many : MOVE.one)
    if (this.#moved < this.#rides[this.#ride]!.states.length - 1) return
    this.#ride += 1
    if (this.done) this.#clock.stop()
    else this.#moved = 0
  }
}
