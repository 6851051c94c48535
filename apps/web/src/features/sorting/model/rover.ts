import {
  createSimulation,
  degreesOf,
  paintFloor,
  setMotor,
  stopMotors,
  type Pose,
  type Simulation,
  type World,
} from '@botgarten/simulation'
import { atan2 } from '@botgarten/numbers'

/** A reading of the colour sensor: red, green and blue, 0 to 255. */
export type Reading = readonly [red: number, green: number, blue: number]
export type Way = 'forward' | 'left' | 'right' | 'back'

/** Ticks between two readings. */
const EVERY = 18

/** Bo on its colourful floor: driven by hand or by itself, collecting what its sensor reads. */
export interface Rover {
  readonly world: World
  pose(): Pose
  /** Lets ticks pass. @returns readings that were taken meanwhile */
  advance(ticks: number, drive: Way | 'lanes' | null): readonly Reading[]
  now(): Reading
}

const speeds: { readonly [way in Way]: readonly [left: number, right: number] } = {
  forward: [45, 45],
  back: [-35, -35],
  left: [-14, 14],
  right: [14, -14],
}

export function createRover(world: World, seed: number): Rover {
  const simulation = createSimulation(world, paintFloor(world), seed)
  const lanes = lanesOver(world)
  let next = 0
  let ticks = 0
  const rover = {
    world,
    pose: () => poseOf(simulation),
    now: () => read(simulation),
    advance(count: number, drive: Way | 'lanes' | null) {
      const found: Reading[] = []
      for (let tick = 0; tick < count; tick++) {
        if (drive === 'lanes' && isNear(poseOf(simulation), lanes[next]!)) next = (next + 1) % lanes.length
        steer(simulation, drive === 'lanes' ? towards(poseOf(simulation), lanes[next]!) : drive)
        simulation.step()
        if (drive !== null && ++ticks % EVERY === 0) found.push(read(simulation))
      }
      return found
    },
  }
  return rover
}

const read = (simulation: Simulation): Reading =>
  (['red', 'green', 'blue'] as const).map((mode) =>
    Number(simulation.read(0, '1', mode)),
  ) as unknown as Reading

function poseOf(simulation: Simulation): Pose {
  const { x, y, heading } = simulation.state.robots[0]!
  return { x, y, heading: degreesOf(heading) }
}

function steer(simulation: Simulation, way: Way | null): void {
  if (way === null) return stopMotors(simulation, 0)
  const { left, right } = simulation.world.robots[0]!.config.drive
  setMotor(simulation, 0, left, speeds[way][0])
  setMotor(simulation, 0, right, speeds[way][1])
}

type Place = Pick<Pose, 'x' | 'y'>
const isNear = (a: Place, b: Place) => Math.abs(a.x - b.x) < 6 && Math.abs(a.y - b.y) < 6

function towards(pose: Pose, place: Place): Way {
  const wanted = (atan2(place.y - pose.y, place.x - pose.x) * 180) / 3.141592653589793
  const off = ((wanted - pose.heading + 540) % 360) - 180
  return off > 4 ? 'left' : off < -4 ? 'right' : 'forward'
}

/** To and fro over the whole floor. */
function lanesOver({ size }: World): Place[] {
  const rows = [0.15, 0.38, 0.62, 0.85]
  return rows.flatMap((row, index) => {
    const ends = index % 2 === 0 ? [0.9, 0.9] : [0.1, 0.1]
    const next = rows[index + 1] ?? rows[0]!
    return [
      { x: ends[0]! * size.width, y: row * size.height },
      { x: ends[1]! * size.width, y: next * size.height },
    ]
  })
}
