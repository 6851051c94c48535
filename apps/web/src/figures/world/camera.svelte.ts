import { follow, type Camera } from '#drawing/camera.ts'
import type { Size } from '#drawing/points.ts'

/** A camera that follows. It moves with every new target; when none comes it goes on by itself until it has arrived. */
export class FollowingCamera {
  #at = $state.raw<Camera>({ x: 0, y: 0, scale: 1 })
  #target: Camera = this.#at
  #frame = 0
  #last = 0
  /** Looks where a child has pushed the floor, until the target moves away from this. */
  #pushed: Camera | null = null

  /** A hand has chosen where to look: the next target is what it looks away from. */
  #holds = false

  get at(): Camera {
    return this.#at
  }

  /** Goes to `target`: at once with `jump` or at another scale, else smoothly. */
  goTo(target: Camera, jump: boolean): void {
    if (this.#holds) this.#pushed = target
    this.#holds = false
    if (this.#pushed && target.scale === this.#pushed.scale && near(target, this.#pushed)) return
    this.#pushed = null
    this.#target = target
    if (jump || target.scale !== this.#at.scale) this.#at = target
    else this.#step(performance.now())
  }

  /** Stays where it is. */
  rest(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#target = this.#at
  }

  /** The floor is pushed by hand; the camera follows again when its target moves. */
  push(to: Camera): void {
    this.#pushed ??= this.#target
    this.#at = to
  }

  /** Looks there, at another scale perhaps, and stays until the target moves. */
  hold(at: Camera): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#at = at
    this.#target = at
    this.#holds = true
  }

  #step(now: number): void {
    // After a rest the first step is one frame long.
    const seconds = now - this.#last > 100 ? 1 / 60 : (now - this.#last) / 1000
    this.#last = now
    if (!this.#arrived()) this.#at = follow(this.#at, this.#target, seconds)
    if (!this.#arrived() && !this.#frame) this.#frame = requestAnimationFrame((next) => this.#goOn(next))
  }

  #goOn(now: number): void {
    this.#frame = 0
    // Targets still come in: they move the camera themselves.
    if (now - this.#last < 30) this.#frame = requestAnimationFrame((next) => this.#goOn(next))
    else this.#step(now)
  }

  #arrived(): boolean {
    if (this.#pushed) return true
    return this.#at.x === this.#target.x && this.#at.y === this.#target.y
  }
}

const near = (a: Camera, b: Camera) => Math.hypot(a.x - b.x, a.y - b.y) < 2

/** How close the camera stands, in px per cm. It steps back when more has to be in sight, and near only in a new pane. */
export class Zoom {
  #at = $state(1)
  #pane: Size | null = null
  #floor: Size | null = null

  get at(): number {
    return this.#asked ?? this.#at
  }

  /** How close a hand has asked for; null: as is best. */
  #asked = $state<number | null>(null)

  ask(scale: number | null): void {
    this.#asked = scale
  }

  fit(pane: Size, floor: Size, wanted: number): void {
    if (!same(this.#floor, floor)) this.#asked = null
    const sameRoom = same(this.#pane, pane) && same(this.#floor, floor)
    this.#pane = pane
    this.#floor = floor
    if (!sameRoom || wanted < this.#at) this.#at = wanted
  }
}

const same = (a: Size | null, b: Size) => a?.width === b.width && a.height === b.height
