import { follow, type Camera } from '../drawing/camera.ts'
import type { Size } from '../drawing/points.ts'

/** A camera that follows on its own frames and rests when it has arrived. */
export class FollowingCamera {
  #at = $state.raw<Camera>({ x: 0, y: 0, scale: 1 })
  #target: Camera = this.#at
  #frame = 0
  #last = 0

  get at(): Camera {
    return this.#at
  }

  /** Goes to `target`: at once with `jump` or at another scale, else smoothly. */
  goTo(target: Camera, jump: boolean): void {
    this.#target = target
    if (jump || target.scale !== this.#at.scale) this.#at = target
    else if (!this.#frame && !this.#arrived()) this.#begin()
  }

  /** Stays where it is. */
  rest(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#target = this.#at
  }

  #begin(): void {
    this.#last = performance.now()
    this.#frame = requestAnimationFrame((now) => this.#step(now))
  }

  #step(now: number): void {
    this.#at = follow(this.#at, this.#target, Math.max(0, now - this.#last) / 1000)
    this.#last = now
    this.#frame = this.#arrived() ? 0 : requestAnimationFrame((next) => this.#step(next))
  }

  #arrived(): boolean {
    return this.#at.x === this.#target.x && this.#at.y === this.#target.y
  }
}

/** How close the camera stands, in px per cm. It steps back when more has to be in sight, and near only in a new pane. */
export class Zoom {
  #at = $state(1)
  #pane: Size | null = null
  #floor: Size | null = null

  get at(): number {
    return this.#at
  }

  fit(pane: Size, floor: Size, wanted: number): void {
    const sameRoom = same(this.#pane, pane) && same(this.#floor, floor)
    this.#pane = pane
    this.#floor = floor
    if (!sameRoom || wanted < this.#at) this.#at = wanted
  }
}

const same = (a: Size | null, b: Size) => a?.width === b.width && a.height === b.height
