import { driveArc, type Motion } from './body/drive.ts'
import { runMotors } from './body/motors.ts'
import { gapToEdge, gapToSide } from './geometry/gaps.ts'
import { findNear, type Ground } from './geometry/near.ts'
import { moveBody } from './geometry/outlines.ts'
import { stepPhysics, type Moving } from './physics/step.ts'
import { physicsOf, type Scene } from './scene.ts'
import { drawNoise } from './sensors/noise.ts'
import { KEYFRAME_EVERY, TICKS_PER_SECOND } from './time.ts'
import { noteBefore, undoSqueezing } from './squeezing.ts'
import { noteTouching } from './touching.ts'
import type { RobotState } from './types.ts'

/** cm/s that a sliding thing loses in a tick: a tenth of its weight holds it. */
const SLIDING_LOSS = (0.1 * 981) / TICKS_PER_SECOND
/** Beyond what may be moved in a tick, so much is looked at for contacts. */
const SLACK = 0.1

/** Motors, then physics: one tick (running.md 2). */
export function stepScene(scene: Scene): void {
  const reach = Math.max(orderRobots(scene), slowThings(scene))
  if (reach > 0) {
    findNear(scene.ground, scene.moving, 2 * reach + SLACK, scene.near)
    if (scene.near.count === 0) moveFreely(scene)
    else moveByPhysics(scene)
  }
  scene.state.tick++
  if (scene.state.tick % KEYFRAME_EVERY === 0) scene.physics = null
  endTones(scene.state.robots, scene.state.tick)
  if (scene.noise.isOn) {
    scene.state.noise = scene.noise.next
    drawNoise(scene.noise, scene.world, scene.state)
  }
}

/** Runs the motors and notes which robots will move. Returns the longest way of any of their points, in cm. */
function orderRobots({ world, state, ground, motions, moving, wheels }: Scene): number {
  let farthest = 0
  for (let robot = 0; robot < motions.length; robot++) {
    const { config } = world.robots[robot]!
    runMotors(state.robots[robot]!, config, wheels)
    driveArc(config, state.robots[robot]!.heading, wheels, motions[robot]!)
    const way = wayOf(motions[robot]!, ground.outlines.reach[robot]!)
    moving[robot] = way > 0 ? 1 : 0
    farthest = Math.max(farthest, way)
  }
  return farthest
}

/** The floor holds sliding things. Notes which go on and returns the longest way of any of their points, in cm. */
function slowThings({ state, ground, moving, motions }: Scene): number {
  let farthest = 0
  for (let index = 0; index < state.obstacles.length; index++) {
    const thing = state.obstacles[index]!
    const body = motions.length + index
    const reach = ground.outlines.reach[body]!
    if (thing.vx !== 0 || thing.vy !== 0 || thing.spin !== 0) slow(thing, reach)
    const way = (lengthOf(thing.vx, thing.vy) + Math.abs(thing.spin) * reach) / TICKS_PER_SECOND
    moving[body] = way > 0 ? 1 : 0
    farthest = Math.max(farthest, way)
  }
  return farthest
}

/** Friction of a disc that slides, and of one that turns on the spot: 4/3 of it at the rim. */
function slow(thing: Moving, reach: number): void {
  const speed = lengthOf(thing.vx, thing.vy)
  const kept = 1 - SLIDING_LOSS / speed
  thing.vx = kept > 0 ? thing.vx * kept : 0
  thing.vy = kept > 0 ? thing.vy * kept : 0
  const left = Math.abs(thing.spin) - ((4 / 3) * SLIDING_LOSS) / reach
  thing.spin = left > 0 ? Math.sign(thing.spin) * left : 0
}

const lengthOf = (x: number, y: number) => Math.sqrt(x * x + y * y)
const wayOf = ({ x, y, turn }: Motion, reach: number) => lengthOf(x, y) + Math.abs(turn) * reach

/** Nothing is near anything: robots go their arcs, things slide on. */
function moveFreely({ state, ground, motions, moving }: Scene): void {
  for (let robot = 0; robot < motions.length; robot++) {
    const own = state.robots[robot]!
    if (moving[robot] === 0) continue
    own.x += motions[robot]!.x
    own.y += motions[robot]!.y
    own.heading += motions[robot]!.turn
    if (own.touching.length > 0) own.touching = []
    moveBody(ground.outlines, robot, own.x, own.y, own.heading)
  }
  for (let index = 0; index < state.obstacles.length; index++) {
    const body = motions.length + index
    const thing = state.obstacles[index]!
    if (moving[body] === 0) continue
    thing.x += thing.vx / TICKS_PER_SECOND
    thing.y += thing.vy / TICKS_PER_SECOND
    thing.heading += thing.spin / TICKS_PER_SECOND
    moveBody(ground.outlines, body, thing.x, thing.y, thing.heading)
  }
}

function moveByPhysics(scene: Scene): void {
  const { near, places, ground, motions, state } = scene
  motions.forEach((motion, robot) => order(places[robot]!, state.robots[robot]!, motion))
  noteBefore(scene)
  stepPhysics(physicsOf(scene), near, places)
  for (let body = 0; body < places.length; body++)
    if (near.active[body] === 1) settleOnFloor(ground, body, places[body]!)
  undoSqueezing(scene)
  state.robots.forEach((robot, body) => {
    const { x, y, heading } = places[body]!
    robot.x = x
    robot.y = y
    robot.heading = heading
  })
  noteTouching(scene)
}

/** Where a body is wedged so that physics would push it off the floor, the floor wins. */
function settleOnFloor(ground: Ground, body: number, place: Moving): void {
  const { outlines } = ground
  moveBody(outlines, body, place.x, place.y, place.heading)
  if (gapToEdge(outlines, body, ground) >= 0) return
  const outBy = (side: number) => Math.max(0, 0 - gapToSide(outlines, body, side, ground))
  place.x += outBy(0) - outBy(1)
  place.y += outBy(2) - outBy(3)
  moveBody(outlines, body, place.x, place.y, place.heading)
}

function order(place: Moving, robot: RobotState, motion: Motion): void {
  place.x = robot.x
  place.y = robot.y
  place.heading = robot.heading
  place.vx = motion.x * TICKS_PER_SECOND
  place.vy = motion.y * TICKS_PER_SECOND
  place.spin = motion.turn * TICKS_PER_SECOND
}

function endTones(robots: readonly RobotState[], tick: number): void {
  for (const robot of robots) {
    const until = robot.tone?.untilTick
    if (until !== undefined && until !== null && tick >= until) robot.tone = null
  }
}
