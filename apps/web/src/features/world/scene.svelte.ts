import type { RobotView } from '@botgarten/lab'
import type { Pose, RobotConfig, World } from '@botgarten/simulation'
import { drawBadge, drawLead } from '#drawing/badges.ts'
import { drawBeyond } from '#drawing/beyond.ts'
import { partAt, partsOf } from '#drawing/bo.ts'
import { onFloor } from '#drawing/camera.ts'
import type { Command } from '#drawing/commands.ts'
import type { Gap } from '#drawing/gap.ts'
import { boRadius, grabbedAt, hitOf, roundHit, type Grabbed } from '#drawing/grab.ts'
import { turned, type Point } from '#drawing/points.ts'
import { Resting } from '#drawing/resting.ts'
import { readingsOf } from '#drawing/senses.ts'
import { ahead, clockwise, radiusOf } from '#drawing/things.ts'
import { Trails, type Dots } from '#drawing/trail.ts'
import type { Chosen } from '#drawing/chosen.ts'
import type { Ghost } from '#drawing/ghost.ts'
import { drawResting, drawWorld, type Scene } from '#drawing/world.ts'
import type { Highlight } from '#figures/highlight.svelte.ts'
import { letters } from '#figures/letters.svelte.ts'
import { bodies, robotName } from '#figures/robot-names.ts'
import type { Viewport } from '#figures/world/viewport.svelte.ts'
import type { Place } from '#lab/door.ts'
import { comfort } from '#storage/comfort.svelte.ts'
import { fetchWords, m } from '#words/message.ts'
import type { Hand } from './hand.svelte.ts'
import { badgeMemory, layBadges, withRays } from './lay-badges.ts'
import type { Shown } from './shown.ts'
import { standing, type Standing } from './steady.ts'
import { thingName } from '#content/thing-name.ts'

const configsOf = ({ robots }: World): ReadonlyMap<string, RobotConfig> =>
  new Map(robots.map(({ id, config }) => [id, config]))

const noDots: Dots = { done: [], growing: [] }

/** What a hand has chosen, and how it is turned. */
interface Selected {
  readonly id: string
  readonly pose: Pose
  readonly name: string
  /** Middle of the turning handle, in px of the floor's box. */
  readonly handle: Point
}

/** What is painted of the world now, and what of it a finger meets. */
export class WorldScene {
  readonly #shown: () => Shown
  readonly #viewport: Viewport
  readonly #hand: Hand
  readonly #highlight: Highlight | undefined
  readonly #trails = new Trails()
  #standing: readonly Standing[] = []
  /** Have the words for the past come? */
  #words = $state(false)

  constructor(shown: () => Shown, viewport: Viewport, hand: Hand, highlight: Highlight | undefined) {
    this.#shown = shown
    this.#viewport = viewport
    this.#hand = hand
    this.#highlight = highlight
  }

  readonly #configs = $derived.by(() => configsOf(this.#shown().world))

  /** What has not moved is the same object as before. */
  readonly things = $derived.by(() => {
    const { view, world } = this.#shown()
    this.#standing = standing(view, world, this.#standing)
    return this.#standing
  })

  readonly #split = new Resting<Standing>()
  readonly #apart = $derived.by(() => this.#split.split(this.things))
  readonly #restingThings = $derived.by(() => this.#apart.resting)
  readonly #floor = $derived.by(() => this.#shown().world.size)
  readonly #place = $derived.by(() => this.#shown().place)
  readonly #resting = $derived.by(() =>
    drawResting(this.#restingThings, this.#floor, this.#viewport.scale, this.#place),
  )

  readonly selected: Selected | null = $derived.by(() => {
    const id = this.#hand.selected
    const index = this.#shown().view.robots.findIndex((one) => one.id === id)
    const robot = this.#shown().view.robots[index]
    // Ahead of a robot are its rays: it is turned by its back.
    if (robot) return this.#turnable(robot, robotName(index), boRadius, 180)
    const found = this.things.find((one) => one.id === id)
    return found ? this.#turnable(found, thingName(found.thing), radiusOf(found.thing.shape), 0) : null
  })

  #turnable({ id, pose }: { id: string; pose: Pose }, name: string, radius: number, side: number): Selected {
    return { id, pose, name, handle: this.#handleAt(pose, radius, side) }
  }

  /** The turning handle stands on this side (degrees from ahead), or opposite where that is out of sight. */
  #handleAt(pose: Pose, radius: number, side: number): Point {
    const { scale } = this.#viewport
    const away = Math.max(radius, 22 / scale) + 32 / scale
    const at = (turn: number) => this.#at(ahead(pose, pose.heading + turn, away))
    return this.#viewport.sees(at(side)) ? at(side) : at(side + 180)
  }

  #at(point: Point): Point {
    return onFloor(point, this.#shown().world.size, this.#viewport.scale)
  }

  readonly #chosen: Chosen | null = $derived.by(() => {
    if (!this.selected) return null
    const { id, pose, handle } = this.selected
    const thing = this.things.find((one) => one.id === id)?.thing
    const { scale } = this.#viewport
    return {
      at: this.#at(pose),
      turn: thing ? clockwise(pose.heading) : 90 - pose.heading,
      hit: thing ? hitOf(thing, scale) : roundHit(boRadius, scale),
      handle,
    }
  })

  readonly #ghosts: readonly Ghost[] = $derived.by(() => {
    const { view, inside, gap, robot } = this.#shown()
    const { present } = view.time
    if (present.length > 0 && !this.#words) void fetchWords('time').then(() => (this.#words = true))
    const then = this.#words ? present : []
    return [
      ...then.map((one) => ({ ...one, label: m['time.ghost'](), grey: true })),
      ...(inside?.ghost ? [{ ...inside.ghost, grey: false }] : []),
      ...(gap?.began ? [{ id: robot, pose: gap.began, label: m['world.began'](), grey: true }] : []),
    ].flatMap(({ id, pose, label, grey }) => {
      const config = this.#configs.get(id)
      return config ? [{ config, pose, label, labelWidth: letters.widthOf(label, 14.5, 'read'), grey }] : []
    })
  })

  readonly #gap: Gap | null = $derived.by(() => {
    const { gap } = this.#shown()
    if (!gap) return null
    const labelWidth = letters.widthOf(gap.label, 18, 'title')
    return { from: this.#at(gap.from), to: this.#at(gap.to), label: gap.label, labelWidth }
  })

  /** What is written at robots that do not stand there now, a line for each; text: the page takes it only when it changes. */
  readonly ghostNames = $derived.by(() => this.#ghosts.map(({ label }) => label).join('\n'))

  readonly #dots: Dots = $derived.by(() => {
    const { world, view, showTrail } = this.#shown()
    const { scale } = this.#viewport
    return showTrail ? this.#trails.dots(view.robots, world.size, scale, bodies) : noDots
  })

  /** Dots of trails that stay as they are; the others are in the shapes. */
  readonly trail = $derived.by(() => this.#dots.done)

  readonly #robots = $derived.by(() => withRays(this.#shown().view.robots, this.#shown().ports))

  readonly now: Scene = $derived.by(() => {
    const { world, robot, showRays } = this.#shown()
    const { scale } = this.#viewport
    return {
      floor: world.size,
      scale,
      seen: this.#viewport.seen,
      view: { robots: this.#robots },
      configs: this.#configs,
      things: this.things,
      moving: this.#apart.moving,
      resting: this.#resting,
      colours: bodies,
      trails: this.#dots.growing,
      sensing: showRays ? robot : null,
      ghosts: this.#ghosts,
      gap: this.#gap,
      chosen: this.#chosen,
      lights: (id, part) => this.#highlight?.lightsPart(id, part) ?? false,
      strong: comfort.has('projector'),
    }
  })

  /** Badges beside the robot, with their boxes in px of the floor's box. */
  readonly #badges = $derived.by(() => {
    const { badges, robot, view } = this.#shown()
    const { robots } = this.now.view
    const shown = robots.find(({ id }) => id === robot)
    if (!shown) return []
    const readings = this.now.sensing === robot ? this.#readings(shown) : []
    const others = robots.filter((one) => one !== shown).map(({ pose }) => this.#at(pose))
    const stands = { bo: this.#at(shown.pose), heading: shown.pose.heading, tick: view.tick }
    const around = { ...stands, others, readings, viewport: this.#viewport }
    return layBadges(badges, around, this.#badgeMemory).map((laid) => ({
      ...laid,
      to: this.#partOf(shown, laid.badge.part),
    }))
  })
  readonly #badgeMemory = badgeMemory()

  /** Where a part of it is; its middle where that is not to be pointed at. */
  #partOf(robot: RobotView, part: string): Point {
    return this.#parts(robot).find((one) => one.part === part) ?? this.#at(robot.pose)
  }

  /** What was learned by trying, under the robot or over it. */
  #tried(where: 'under' | 'over'): readonly Command[] {
    const { senses, view, robot } = this.#shown()
    const one = senses && view.robots.find(({ id }) => id === robot)
    if (!one) return []
    const { scale, seen } = this.#viewport
    const { heading } = one.pose
    if (where === 'over') return senses.over(this.#at(one.pose), heading, scale)
    return senses.under(this.#at(one.pose), heading, scale, seen)
  }

  readonly shapes = $derived.by(() => [
    ...this.#tried('under'),
    ...drawWorld(this.now),
    ...this.#tried('over'),
    ...drawBeyond(this.now),
    ...this.#badges.map(({ badge, box, to }) => drawLead(badge, box, to)),
    ...this.#badges.flatMap(({ badge, box, label }) => drawBadge(badge, box, label)),
  ])

  /** What a finger takes at a point of the pane, in px. */
  grabbedAt(at: Point): Grabbed | null {
    return grabbedAt(this.now, this.#onFloor(at))
  }

  /** The robot and its part (`motor C`) under a point of the pane; a part of null: between its parts. */
  partAt(at: Point): { readonly id: string; readonly part: string | null } | null {
    const grabbed = this.grabbedAt(at)
    if (grabbed?.kind !== 'robot') return null
    const { id, pose } = grabbed
    const config = this.#configs.get(id)
    const middle = this.#at(pose)
    const point = this.#onFloor(at)
    const own = turned({ x: point.x - middle.x, y: point.y - middle.y }, pose.heading - 90)
    return config ? { id, part: partAt(config, this.#viewport.scale, own) } : null
  }

  /** Where everything is painted that can be pointed at or read, in px of the pane. */
  places(): readonly Place[] {
    const { view, sensing, lights } = this.now
    const { corner } = this.#viewport
    const inPane = ({ x, y, ...rest }: Place) => ({
      ...rest,
      x: x + Math.round(corner.x),
      y: y + Math.round(corner.y),
    })
    return [
      ...view.robots.flatMap((robot) => [
        { name: robot.id, ...this.#at(robot.pose) },
        ...this.#parts(robot).map((place) => ({ ...place, lit: lights(robot.id, place.part) })),
        ...(robot.id === sensing ? this.#readings(robot) : []),
      ]),
      ...this.#badges.map(({ badge, box }) => ({
        name: `${this.#shown().robot} badge ${badge.id}`,
        x: box.x + box.width / 2,
        y: box.y + box.height / 2,
        text: [badge.label, ...badge.value].join(' '),
      })),
      ...this.things.map(({ id, pose }) => ({ name: id, ...this.#at(pose) })),
    ].map(inPane)
  }

  #parts({ id, pose }: RobotView): readonly (Place & { readonly part: string })[] {
    const config = this.#configs.get(id)
    const { scale } = this.#viewport
    const middle = this.#at(pose)
    return (config ? partsOf(config) : []).map(({ part, x, y }) => {
      const off = turned({ x: x * scale, y: y * scale }, 90 - pose.heading)
      return { part, name: `${id} ${part}`, x: middle.x + off.x, y: middle.y + off.y }
    })
  }

  #readings(robot: RobotView): readonly Place[] {
    const config = this.#configs.get(robot.id)
    const readings = config ? readingsOf(robot, config, this.now) : []
    return readings.map(({ port, reading, label }) => ({
      name: `${robot.id} ray ${port}`,
      ...label,
      text: String(reading),
    }))
  }

  #onFloor({ x, y }: Point): Point {
    const { corner } = this.#viewport
    return { x: x - Math.round(corner.x), y: y - Math.round(corner.y) }
  }
}
