import type { View } from '@botgarten/lab'
import type { World } from '@botgarten/simulation'
import {
  aim,
  bringing,
  floorCorner,
  fromPane,
  keepOnFloor,
  needOf,
  needOfAll,
  nearestZoom,
  scaleFor,
  wholeScale,
  type Camera,
  type Sight,
} from '#drawing/camera.ts'
import { clamp, type Point, type Size } from '#drawing/points.ts'
import { radiusOf } from '#drawing/things.ts'
import { FollowingCamera, Zoom } from './camera.svelte.ts'

// Px from the pane's edge within which a handle could not be grabbed.
const edge = 22

// Of a robot, in cm.
const bodyRadius = 13

// Across, in cm: what is drawn round a robot that is looked at alone.
const around = 220

// Px that an arrow key pushes the floor.
const step = 60
const arrows: { readonly [key: string]: readonly [right: number, down: number] } = {
  ArrowLeft: [1, 0],
  ArrowRight: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

const radiiOf = ({ obstacles }: World): ReadonlyMap<string, number> =>
  new Map(obstacles.map(({ id, shape }) => [id, radiusOf(shape)]))

/** What part of the world is seen in the pane, and the ways between the two. */
export class Viewport {
  pane = $state.raw<Size>({ width: 0, height: 0 })
  #camera = new FollowingCamera()
  #zoom = new Zoom()
  #world: () => World
  #chosen: () => string
  #whole: () => boolean
  #goals: () => readonly Sight[]
  #alone: () => boolean
  #wide: boolean
  /** How close the camera was sent to show something. */
  #sent: number | null = null
  #radii = $derived.by(() => radiiOf(this.#world()))
  /** The floor's top left corner in px of the pane. */
  corner = $derived.by(() => floorCorner(this.#at, this.pane, this.#world().size))

  /**
   * @param followed id of the robot that the camera follows; the first where there is none of this name
   * @param whole is the whole floor the thing, as a map is?
   * @param goals places on the floor that matter as things do
   * @param alone is it the robot and what is drawn round it that is looked at, and no thing?
   * @param wide is as much of the floor's width shown as leaves the robot large enough?
   */
  constructor(
    world: () => World,
    followed: () => string = () => '',
    whole: () => boolean = () => false,
    goals: () => readonly Sight[] = () => [],
    alone: () => boolean = () => false,
    wide = false,
  ) {
    this.#world = world
    this.#chosen = followed
    this.#whole = whole
    this.#goals = goals
    this.#alone = alone
    this.#wide = wide
  }

  get scale(): number {
    return this.#zoom.at
  }

  /** What is seen of the floor, in px of its box. */
  get seen(): Size & Point {
    return { x: -this.corner.x, y: -this.corner.y, ...this.pane }
  }

  /** A resting camera is not told of another scale. */
  get #at(): Camera {
    const { x, y } = this.#camera.at
    return { x, y, scale: this.scale }
  }

  get open(): boolean {
    return this.pane.width > 0 && this.pane.height > 0
  }

  /** How close the camera has to stand for what a run begins with. */
  get wantedScale(): number {
    const { robots, obstacles, size } = this.#world()
    const things = obstacles.map(({ pose, shape }) => ({ x: pose.x, y: pose.y, radius: radiusOf(shape) }))
    const robot = this.#followed(robots)
    if (this.#whole() || !robot) return scaleFor(this.pane, size, 'whole')
    // Of several robots none should be out of sight.
    if (robots.length > 1) return scaleFor(this.pane, size, needOfAll(robots.map(({ pose }) => pose)))
    if (this.#wide) return scaleFor(this.pane, size, { width: size.width, height: 0 })
    if (this.#alone()) return scaleFor(this.pane, size, { width: around, height: around })
    return scaleFor(this.pane, size, needOf(robot.pose, [...things, ...this.#goals()]))
  }

  #followed = <Robot extends { id: string }>(robots: readonly Robot[]): Robot | undefined =>
    robots.find(({ id }) => id === this.#chosen()) ?? robots[0]

  stand(scale: number): void {
    this.#zoom.fit(this.pane, this.#world().size, scale)
  }

  /** Where the camera should be for this view; null without a robot. */
  target({ robots, obstacles }: View) {
    const robot = this.#followed(robots)
    if (!robot || !this.open) return null
    const several = robots.length > 1
    const things = (several ? robots.filter((one) => one !== robot) : obstacles).map(({ id, pose }) => ({
      x: pose.x,
      y: pose.y,
      radius: this.#radii.get(id) ?? (several ? bodyRadius : 0),
    }))
    const goals = several ? [] : this.#goals()
    const near = this.#alone() && !several ? [] : [...things, ...goals]
    return aim(robot.pose, near, this.scale, this.pane, this.#world().size)
  }

  goTo(target: ReturnType<Viewport['target']>, jump: boolean): void {
    if (target) this.#camera.goTo(target, jump)
  }

  rest(): void {
    this.#camera.rest()
  }

  /** Pushes the floor by px. */
  push(right: number, down: number): void {
    const { x, y, scale } = this.#at
    const to = { x: x - right / scale, y: y + down / scale, scale }
    this.#camera.push(keepOnFloor(to, this.pane, this.#world().size))
  }

  /** How close the whole floor fits into the pane. */
  get wholeScale(): number {
    return wholeScale(this.pane, this.#world().size)
  }

  /** Brings the floor nearer by a factor; the point of it that lies there (px of the pane) stays where it is. */
  zoom(factor: number, at: Point = { x: this.pane.width / 2, y: this.pane.height / 2 }): void {
    const least = Math.min(this.wholeScale, this.scale)
    const scale = clamp(this.scale * factor, least, nearestZoom)
    const fixed = this.floorAt(at)
    this.#zoom.ask(scale)
    const camera = {
      x: fixed.x - (at.x - this.pane.width / 2) / scale,
      y: fixed.y + (at.y - this.pane.height / 2) / scale,
      scale,
    }
    this.#camera.hold(keepOnFloor(camera, this.pane, this.#world().size))
  }

  /** Shows these places until `follow`, from farther away where it has to be. */
  bringInSight(points: readonly Point[]): void {
    const there = this.open && bringing(points, this.#at, this.pane, this.#world().size)
    if (!there) return
    this.#sent = there.scale
    this.#zoom.ask(there.scale)
    this.#camera.hold(there)
  }

  /** Looks at the robot again, as close as before, unless a hand has chosen another view since. */
  follow(): void {
    if (this.#sent !== null && this.#sent === this.#zoom.at) this.#zoom.ask(null)
    this.#sent = null
  }

  /** The whole floor in sight. */
  fitAll(): void {
    const { width, height } = this.#world().size
    this.#zoom.ask(this.wholeScale)
    this.#camera.hold({ x: width / 2, y: height / 2, scale: this.wholeScale })
  }

  /** What of the floor lies in the middle of the pane, in cm. */
  get middle(): Point {
    return this.floorAt({ x: this.pane.width / 2, y: this.pane.height / 2 })
  }

  /** Pushes the floor the way of an arrow key. Returns whether it is one. */
  pan(key: string): boolean {
    const way = arrows[key]
    if (way) this.push(way[0] * step, way[1] * step)
    return way !== undefined
  }

  /** Px in the pane to cm on the floor. */
  floorAt = (at: Point): Point => fromPane(at, this.#at, this.pane)

  /** Can this point (px of the floor's box) be grabbed in the pane? */
  sees = ({ x, y }: Point): boolean => {
    const left = x + this.corner.x
    const top = y + this.corner.y
    return left > edge && top > edge && left < this.pane.width - edge && top < this.pane.height - edge
  }
}
