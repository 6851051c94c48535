import type { Motion } from './body/drive.ts'
import type { WheelTurns } from './body/motors.ts'
import { createNearParts, type Ground, type NearParts } from './geometry/near.ts'
import { createOutlines, moveBody } from './geometry/outlines.ts'
import { partOfShape, partsOfRobot, type Part } from './geometry/parts.ts'
import { buildPhysics, type BodyPlan, type Physics } from './physics/bodies.ts'
import type { Moving } from './physics/step.ts'
import { createNoise, drawNoise, type Noise } from './sensors/noise.ts'
import { startState } from './state.ts'
import type { Cm, SimulationState, World } from './types.ts'

/** A world in motion with what is worked out from it once. Bodies are the robots, then the obstacles, in the world's order. */
export interface Scene {
  readonly world: World
  readonly state: SimulationState
  readonly ground: Ground
  /** By body. */
  readonly ids: readonly string[]
  readonly noise: Noise
  readonly parts: readonly (readonly Part[])[]
  readonly near: NearParts
  /** By body: does it move in this tick? */
  readonly moving: Uint8Array
  /** By body: for robots a sheet to reckon on, for obstacles their state. */
  readonly places: Moving[]
  /** By body: place before the physics of this tick: x0, y0, heading0, x1, … */
  readonly before: Float64Array
  readonly motions: readonly Motion[]
  readonly wheels: WheelTurns
  /** Who touches whom, see touching.ts. */
  readonly touched: Uint8Array
  physics: Physics | null
}

export function createScene(world: World, seed: number): Scene {
  const { width, height } = world.size
  const state = startState(world, seed)
  const parts = [
    ...world.robots.map(({ config }) => partsOfRobot(config)),
    ...world.obstacles.map(({ shape }) => [partOfShape(shape)]),
  ]
  const movable = Uint8Array.from([
    ...world.robots.map(() => 1),
    ...world.obstacles.map(({ fixed }) => (fixed ? 0 : 1)),
  ])
  const scene: Scene = {
    world,
    state,
    ground: { outlines: createOutlines(parts), width, height, movable },
    ids: [...world.robots, ...world.obstacles].map(({ id }) => id),
    noise: createNoise(world),
    parts,
    near: createNearParts(parts.length),
    moving: new Uint8Array(parts.length),
    places: [],
    before: new Float64Array(parts.length * 3),
    motions: world.robots.map(() => ({ x: 0, y: 0, turn: 0 })),
    wheels: { left: 0, right: 0 },
    touched: new Uint8Array(world.robots.length * (parts.length + 1)),
    physics: null,
  }
  takeUpState(scene)
  return scene
}

/** Everything that is worked out from the state, again. */
export function takeUpState(scene: Scene): void {
  const { state, places, ground } = scene
  scene.physics = null
  drawNoise(scene.noise, scene.world, state)
  const robots = state.robots.map(({ x, y, heading }) => ({ x, y, heading, vx: 0, vy: 0, spin: 0 }))
  places.splice(0, places.length, ...robots, ...state.obstacles)
  places.forEach(({ x, y, heading }, body) => moveBody(ground.outlines, body, x, y, heading))
}

/** The physics world as it is needed now, built from the state if there is none. */
export function physicsOf(scene: Scene): Physics {
  scene.physics ??= buildPhysics(plansOf(scene), scene.ground.width, scene.ground.height)
  return scene.physics
}

/** In crates: movable things weigh 1 each. With more between them the solver would have to squeeze. */
const ROBOT_MASS = 3
const ROBOT_WEIGHT = weightOf(ROBOT_MASS, 12, false)

function plansOf({ world, places, parts, ground }: Scene): BodyPlan[] {
  const obstacles = world.obstacles.map(({ shape, fixed }, index) => {
    const reach = ground.outlines.reach[world.robots.length + index]!
    return fixed ? null : weightOf(1, reach, shape.kind === 'circle')
  })
  const weights = [...world.robots.map(() => ROBOT_WEIGHT), ...obstacles]
  return parts.map((own, body) => {
    const { x, y, heading } = places[body]!
    return { parts: own, x, y, heading, weight: weights[body]! }
  })
}

/** Inertia of a disc, or of a rectangle (of a triangle roughly) round the middle. */
function weightOf(mass: number, reach: Cm, isRound: boolean): BodyPlan['weight'] {
  return { mass, inertia: (mass * reach * reach) / (isRound ? 2 : 3) }
}
