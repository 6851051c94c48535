import type { View } from '@botgarten/lab'
import type { World } from '@botgarten/simulation'
import { aim, floorCorner, fromPane, keepOnFloor, needOf, scaleFor } from '../drawing/camera.ts'
import type { Point, Size } from '../drawing/points.ts'
import { radiusOf } from '../drawing/things.ts'
import { FollowingCamera, Zoom } from './camera.svelte.ts'

// Px from the pane's edge within which a handle could not be grabbed.
const edge = 22

/** What part of the world is seen in the pane, and the ways between the two. */
export class Eye {
  pane = $state.raw<Size>({ width: 0, height: 0 })
  #camera = new FollowingCamera()
  #zoom = new Zoom()
  #world: () => World
  /** The floor's top left corner in px of the pane. */
  corner = $derived.by(() => floorCorner(this.#camera.at, this.pane, this.#world().size))

  constructor(world: () => World) {
    this.#world = world
  }

  get scale(): number {
    return this.#zoom.at
  }

  get open(): boolean {
    return this.pane.width > 0 && this.pane.height > 0
  }

  /** How close the camera has to stand for what a run begins with. */
  get wantedScale(): number {
    const { robots, obstacles, size } = this.#world()
    const things = obstacles.map(({ pose, shape }) => ({ x: pose.x, y: pose.y, radius: radiusOf(shape) }))
    return scaleFor(this.pane, size, robots[0] ? needOf(robots[0].pose, things) : size)
  }

  stand(scale: number): void {
    this.#zoom.fit(this.pane, this.#world().size, scale)
  }

  /** Where the camera should be for this view; null without a robot. */
  target({ robots, obstacles }: View) {
    const robot = robots[0]
    if (!robot || !this.open) return null
    const shapes = this.#world().obstacles
    const things = obstacles.map(({ id, pose }) => {
      const shape = shapes.find((one) => one.id === id)?.shape
      return { x: pose.x, y: pose.y, radius: shape ? radiusOf(shape) : 0 }
    })
    return aim(robot.pose, things, this.scale, this.pane, this.#world().size)
  }

  goTo(target: ReturnType<Eye['target']>, jump: boolean): void {
    if (target) this.#camera.goTo(target, jump)
  }

  rest(): void {
    this.#camera.rest()
  }

  /** Pushes the floor by px. */
  push(right: number, down: number): void {
    const { x, y } = this.#camera.at
    const to = { x: x - right / this.scale, y: y + down / this.scale, scale: this.scale }
    this.#camera.push(keepOnFloor(to, this.pane, this.#world().size))
  }

  /** Px in the pane to cm on the floor. */
  floorAt = (at: Point): Point => fromPane(at, this.#camera.at, this.pane)

  /** Can this point (px of the floor's box) be grabbed in the pane? */
  sees = ({ x, y }: Point): boolean => {
    const left = x + this.corner.x
    const top = y + this.corner.y
    return left > edge && top > edge && left < this.pane.width - edge && top < this.pane.height - edge
  }
}
