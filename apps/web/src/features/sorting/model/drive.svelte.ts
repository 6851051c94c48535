import type { Pose } from '@botgarten/simulation'
import type { Playground } from './playground.svelte.ts'
import type { Rover, Way } from './rover.ts'
import { MOST_READINGS } from './work.ts'

/** Bo drives over its floor, by hand or by itself, and what it reads comes onto the playground. */
export class Drive {
  readonly #playground: Playground
  readonly #rover: Rover
  #pose: Pose = $state.raw({ x: 0, y: 0, heading: 0 })
  #way = $state<Way | 'lanes' | null>(null)
  #frame = 0
  #before = 0
  #hasRead = false

  constructor(playground: Playground, rover: Rover) {
    this.#playground = playground
    this.#rover = rover
    this.#pose = rover.pose()
  }

  get world(): Rover['world'] {
    return this.#rover.world
  }

  get pose(): Pose {
    return this.#pose
  }

  /** `lanes`: by itself · null: it stands. */
  get way(): Way | 'lanes' | null {
    return this.#way
  }

  go(way: Way | 'lanes'): void {
    if (this.#way === way || this.#isFull) return
    this.#way = way
    cancelAnimationFrame(this.#frame)
    this.#before = performance.now()
    this.#frame = requestAnimationFrame(this.#beat)
  }

  halt(): void {
    if (this.#way === null) return
    cancelAnimationFrame(this.#frame)
    this.#rover.advance(1, null)
    this.#way = null
    this.#hasRead = false
    this.#playground.endCollecting()
  }

  /** The floor is left. */
  close(): void {
    cancelAnimationFrame(this.#frame)
    this.#playground.endCollecting()
  }

  get #isFull(): boolean {
    return this.#playground.work.table.rows.length >= MOST_READINGS
  }

  #beat = (now: number): void => {
    // A tick is a sixtieth of a second; by itself Bo drives three times as fast, and reads ten times a second.
    const passed = Math.min(30, Math.floor(((now - this.#before) * 60) / 1000))
    if (passed > 0) {
      this.#before = now
      const isTakenBack = this.#hasRead && !this.#playground.collecting
      if (isTakenBack) return this.halt()
      this.#advance(passed * (this.#way === 'lanes' ? 3 : 1))
    }
    if (this.#way !== null && !this.#isFull) this.#frame = requestAnimationFrame(this.#beat)
    else this.halt()
  }

  #advance(ticks: number): void {
    const found = this.#rover.advance(ticks, this.#way)
    if (found.length > 0) this.#playground.collect(found)
    this.#hasRead ||= found.length > 0
    this.#pose = this.#rover.pose()
  }
}
