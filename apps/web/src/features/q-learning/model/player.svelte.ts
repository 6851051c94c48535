import type { Course } from '@botgarten/learning/q-learning'
import { budgetFor, Clock } from './clock.ts'
import type { Screen } from './screen.svelte.ts'
import { MOVE } from './time.ts'

/** Moves between two readings of the clock in turbo. */
const SLICE = 400

interface Host {
  readonly screen: Screen
  readonly course: () => Course
  /** A limit stopped it. */
  readonly onend: () => void
  /** The one move that was asked for is made. */
  readonly onpause: () => void
  /** Once a frame. */
  readonly onframe: (now: number) => void
}

/** Plays the moves of a course: one after the other at a speed, or as many as a frame has time for. */
export class Player {
  readonly #host: Host
  readonly #clock = new Clock((passed, now) => this.#turn(passed, now))
  #progress = $state(1)
  /** 1, 2, 3; Infinity: turbo. */
  speed = $state(1)
  /** The move that is on is the last. */
  #single = false

  constructor(host: Host) {
    this.#host = host
  }

  /** 0..1 of the move that is shown. */
  get progress() {
    return this.#progress
  }

  show(progress: number): void {
    this.#progress = progress
    this.#host.screen.show(this.#host.course())
  }

  showInTurns(): void {
    this.#progress = 1
    this.#host.screen.showInTurns(this.#host.course())
  }

  start(single: boolean): void {
    this.#single = single
    this.#clock.start()
  }

  /** The move that is on becomes the last. */
  endAfterMove(): void {
    this.#single = true
  }

  stop(): void {
    this.#clock.stop()
  }

  #turn(passed: number, now: number): void {
    if (this.speed === Infinity && !this.#single) this.#hurry(passed)
    else this.#pace((passed * (Number.isFinite(this.speed) ? this.speed : 1)) / MOVE)
    this.#host.onframe(now)
  }

  /** Turbo: learns for a limited time in every frame. */
  #hurry(passed: number): void {
    const course = this.#host.course()
    const end = performance.now() + budgetFor(passed)
    do course.advance(SLICE)
    while (!course.over && performance.now() < end)
    this.#progress = 1
    if (course.over) this.#host.onend()
    else if (!this.#host.screen.isBusy) this.#host.screen.showInTurns(course)
  }

  #pace(share: number): void {
    const course = this.#host.course()
    let progress = this.#progress + share
    while (progress >= 1) {
      if (course.over) return this.#host.onend()
      if (this.#single) return this.#host.onpause()
      course.next()
      progress = Math.min(progress - 1, 0.99)
      this.show(progress)
    }
    this.#progress = progress
  }
}
