import type { RobotView, View } from '@botgarten/lab'
import type { Obstacle, Pose, RobotConfig } from '@botgarten/simulation'
import { drawBo, lampAt, lamps, partsOf } from './bo.ts'
import { onFloor } from './camera.ts'
import { ring, turnHandle, type Chosen } from './chosen.ts'
import type { Command } from './commands.ts'
import { drawGap, type Gap } from './gap.ts'
import { drawGhost, type Ghost } from './ghost.ts'
import type { Point, Size } from './points.ts'
import { drawSenses } from './senses.ts'
import { drawShadow, drawThing } from './thing-looks.ts'
import { clockwise } from './things.ts'

// What moves in a world, in px of the floor's box: x to the right, y down from its upper left corner.

/** A thing where it stands. */
export interface Placed {
  readonly pose: Pose
  readonly thing: Obstacle
}

/** All that moves, as it is to be painted. Poses in cm. */
export interface Scene {
  readonly floor: Size
  /** Px per cm. */
  readonly scale: number
  /** What is seen of the floor, in px of its box. */
  readonly seen: Size & Point
  readonly view: Pick<View, 'robots'>
  readonly configs: ReadonlyMap<string, RobotConfig>
  /** All, for a hand. */
  readonly things: readonly Placed[]
  /** Those of them that move. */
  readonly moving: readonly Placed[]
  /** Those that do not, as they are painted. */
  readonly resting: readonly Command[]
  /** Of bodies, by the robot's place among all. */
  readonly colours: readonly string[]
  /** Dots of trails, already commands. */
  readonly trails: readonly Command[]
  /** Id of the robot whose rays are shown; null: nobody's. */
  readonly sensing: string | null
  readonly ghosts: readonly Ghost[]
  readonly chosen: Chosen | null
  /** From Bo to where it should have been. */
  readonly gap: Gap | null
  /** Does this part of this robot light up with its block and its node? */
  readonly lights: (robot: string, part: string) => boolean
  /** Stronger lines and cones, for the wall. */
  readonly strong: boolean
}

const ink = '#3A2A20'
const tomato = '#C9401F'

/** Everything in its order, from the floor up. */
export function drawWorld(scene: Scene): readonly Command[] {
  const { trails, resting, moving, ghosts, view, chosen, gap } = scene
  return [
    ...trails,
    ...resting,
    ...moving.map((one) => standing(one, scene)),
    ...ghosts.flatMap((ghost) => drawGhost(ghost, scene)),
    ...view.robots.map((robot, index) => standingBo(robot, index, scene)),
    ...(chosen ? ring(chosen) : []),
    ...senses(scene),
    ...(gap ? drawGap(gap, scene.scale) : []),
    ...(chosen ? turnHandle(chosen) : []),
  ]
}

const looks = new WeakMap<Obstacle, readonly Command[]>()

/** A thing with its shadow, which falls the same way however the thing is turned. */
function standing({ thing, pose }: Placed, { floor, scale }: Pick<Scene, 'floor' | 'scale'>): Command {
  const turn = clockwise(pose.heading)
  const known = looks.get(thing)
  const look = known ?? drawThing(thing)
  if (!known) looks.set(thing, look)
  return {
    kind: 'group',
    ...onFloor(pose, floor, scale),
    scale,
    shapes: [
      { kind: 'group', x: 3, y: 4, turn, opacity: 0.12, shapes: drawShadow(thing) },
      { kind: 'group', turn, shapes: look },
    ],
  }
}

/** From so many on, one picture of all costs less than each by itself. */
const many = 8

/**
 * Things that rest: the same command for the same things, painted as a picture.
 * @param place what is seen of the floor, in px of its box
 */
export function drawResting(
  things: readonly Placed[],
  floor: Size,
  scale: number,
  place: Size & Point,
): readonly Command[] {
  const shapes = things.map((one) => standing(one, { floor, scale }))
  return things.length < many ? shapes : [{ kind: 'group', still: place, shapes }]
}

const shade: Command = { kind: 'circle', x: 0, y: 0.5, r: 12.2, ry: 11.4, fill: ink, opacity: 0.1 }

function standingBo(robot: RobotView, index: number, scene: Scene): Command {
  const { floor, scale, configs } = scene
  const config = configs.get(robot.id)
  return {
    kind: 'group',
    ...onFloor(robot.pose, floor, scale),
    turn: 90 - robot.pose.heading,
    scale,
    shapes: config ? [...glow(robot), lookOf(robot, config, index, scene), ...bump(robot)] : [],
  }
}

const bodies = new WeakMap<RobotConfig, Map<string, Command>>()
/** In cm: halos and leaves are in it. */
const around = { x: -16, y: -16, width: 32, height: 32 }

/** The same object for the same look: most frames only move Bo. */
function lookOf(
  { id, led, display }: RobotView,
  config: RobotConfig,
  index: number,
  { colours, lights }: Scene,
): Command {
  const text = display.some((row) => row.trim() !== '')
  const lit = partsOf(config).flatMap(({ part }) => (lights(id, part) ? [part] : []))
  const key = [led, text, index, ...lit].join()
  const known = bodies.get(config) ?? new Map<string, Command>()
  bodies.set(config, known)
  const number: Command = {
    kind: 'text',
    x: 0,
    y: 6.2,
    text: String(index + 1),
    size: 4.4,
    font: 'title',
    align: 'middle',
    fill: ink,
  }
  const look: Command = known.get(key) ?? {
    kind: 'group',
    still: around,
    turns: true,
    shapes: [
      shade,
      ...drawBo({ config, led, text, colour: colours[index], lights: (part) => lit.includes(part) }),
      ...(index > 0 ? [{ ...number, x: -3.4 }] : []),
    ],
  }
  known.set(key, look)
  return look
}

/** It bumps with the side it drives towards. */
function bump({ motors, touching }: RobotView): readonly Command[] {
  if (touching.length === 0) return []
  const backwards = Object.values(motors).reduce((sum, speed) => sum + speed, 0) < 0
  const lines: Command = {
    kind: 'path',
    d: 'M-6.5-11.8l-1.7-2.6M0-12.4v-3.2M6.5-11.8l1.7-2.6',
    stroke: tomato,
    lineWidth: 1.3,
  }
  return [backwards ? { kind: 'group', y: -3, turn: 180, shapes: [lines] } : lines]
}

/** Halos of a lamp that shines, in cm about it. */
const halos = [
  { r: 18, opacity: 0.3 },
  { r: 10, opacity: 0.45 },
]

const glow = ({ led }: RobotView): readonly Command[] =>
  led ? halos.map((halo) => ({ kind: 'circle', x: 0, y: lampAt, fill: lamps[led], ...halo })) : []

function senses(scene: Scene): readonly Command[] {
  const robot = scene.view.robots.find(({ id }) => id === scene.sensing)
  const config = robot && scene.configs.get(robot.id)
  return robot && config ? drawSenses(robot, config, scene) : []
}
