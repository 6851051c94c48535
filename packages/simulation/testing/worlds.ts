import { addToHash, hex, startHash } from '@botgarten/numbers'
import { expect } from 'vitest'
import { cardConfig } from '../configs.ts'
import { paintFloor } from '../floor/paint.ts'
import { bodiesWithin } from '../geometry/gaps.ts'
import { createOutlines, moveBody } from '../geometry/outlines.ts'
import { FRONT, HALF_WIDTH, partOfShape, partsOfRobot, REAR } from '../geometry/parts.ts'
import { createSimulation } from '../simulation.ts'
import type {
  Cm,
  Floor,
  Obstacle,
  Pose,
  RobotConfig,
  RobotPlacement,
  Shape,
  Simulation,
  World,
} from '../types.ts'

// What the tests of this room build their worlds with, and the invariants that hold in every one of them.

export const pose = (x: number, y: number, heading = 0): Pose => ({ x, y, heading })

export const robotAt = (at: Pose, config: RobotConfig = cardConfig, id = 'bo'): RobotPlacement => ({
  id,
  pose: at,
  program: 'main',
  brain: '',
  config,
})

export const square = (width: number): Shape => ({ kind: 'rectangle', width, height: width })

export function thing(id: string, shape: Shape, at: Pose, fixed = true): Obstacle {
  return { id, shape, pose: at, fixed, colour: '#0057A6' }
}

const world = (parts: Partial<World> = {}): World => ({
  size: { width: 600, height: 400 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [],
  robots: [robotAt(pose(100, 200))],
  ...parts,
})

export const start = (parts: Partial<World> = {}, seed = 1): Simulation => {
  const all = world(parts)
  const isBare = all.areas.length + all.lines.length === 0
  return createSimulation(all, isBare ? whiteFloor : paintFloor(all), seed)
}

/** One pixel is enough where nothing is painted. */
const whiteFloor: Floor = { width: 1, height: 1, pixelsPerCm: 1, data: new Uint8Array([255, 255, 255]) }

/** Steps and holds the invariants after every tick. */
export function run(sim: Simulation, ticks: number, before: (tick: number) => void = () => undefined): void {
  for (let tick = 0; tick < ticks; tick++) {
    before(tick)
    sim.step()
    expectSane(sim)
  }
}

/** Every number is finite and every corner of every robot is on the floor, but for a hundredth of a millimetre. */
function expectSane(sim: Simulation): void {
  const { width, height } = sim.world.size
  for (const { x, y, heading } of sim.state.robots) {
    const c = Math.cos(heading)
    const s = Math.sin(heading)
    const reachX = Math.max(c * FRONT, -c * REAR) + Math.abs(s) * HALF_WIDTH
    const reachY = Math.max(s * FRONT, -s * REAR) + Math.abs(c) * HALF_WIDTH
    const backX = Math.max(-c * FRONT, c * REAR) + Math.abs(s) * HALF_WIDTH
    const backY = Math.max(-s * FRONT, s * REAR) + Math.abs(c) * HALF_WIDTH
    const room = Math.min(x - backX, width - x - reachX, y - backY, height - y - reachY)
    if (!(room >= -0.001)) expect.fail(`robot off the floor by ${-room} cm at ${x}, ${y}, ${heading}`)
  }
  for (const { id, x, y, heading, vx, vy, spin } of sim.state.obstacles) {
    const isOnFloor = x >= 0 && x <= width && y >= 0 && y <= height
    const isSlow = Math.abs(vx) < 200 && Math.abs(vy) < 200 && Math.abs(spin) < 50
    if (!(isOnFloor && isSlow && Number.isFinite(heading)))
      expect.fail(`${id} out of order: ${JSON.stringify(sim.state.obstacles)}`)
  }
}

/** Places and speeds of everything, as one number to compare. */
export function hashOf({ state }: Simulation): string {
  const hash = startHash()
  for (const { x, y, heading } of state.robots) for (const value of [x, y, heading]) addToHash(hash, value)
  for (const { x, y, heading, vx, vy, spin } of state.obstacles)
    for (const value of [x, y, heading, vx, vy, spin]) addToHash(hash, value)
  return hex(hash)
}

/** Do any two bodies overlap by more than `depth` cm (two fixed ones aside)? */
export function overlapBy({ world, state }: Simulation, depth: Cm): boolean {
  const parts = [
    ...world.robots.map(({ config }) => partsOfRobot(config)),
    ...world.obstacles.map(({ shape }) => [partOfShape(shape)]),
  ]
  const outlines = createOutlines(parts)
  ;[...state.robots, ...state.obstacles].forEach(({ x, y, heading }, body) =>
    moveBody(outlines, body, x, y, heading),
  )
  const isFixed = (body: number) => world.obstacles[body - world.robots.length]?.fixed ?? false
  return parts.some((_, a) =>
    parts.some((_, b) => a < b && !(isFixed(a) && isFixed(b)) && bodiesWithin(outlines, a, b, 0 - depth)),
  )
}
