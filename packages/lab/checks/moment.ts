import { cos, sin } from '@botgarten/numbers'
import {
  FRONT,
  type Cm,
  type Colour,
  type ObstacleState,
  type Percent,
  type ReadMode,
  type RobotState,
  type SensorKind,
  type SensorPort,
  type Shape,
  type Simulation,
  type SimulationState,
  type World,
} from '@botgarten/simulation'

/** What a check sees of one tick: the first robot among the things of its world. */
export interface Moment {
  /** Since the run began. */
  readonly seconds: number
  readonly world: World
  readonly simulation: SimulationState
  /** Reads a sensor of a robot, as its program would. */
  readonly read: Simulation['read']
  /**
   * How the first robot's program would turn it in the next tick, right wheel minus left wheel in percent; `mirrored`: had each
   * of its sensors seen what the one on the other side sees. null where it would set no wheel.
   */
  nextTurn(mirrored: boolean): Percent | null
  /** Has another check of the card passed? */
  passed(checkId: string): boolean
}

export const robotIn = (moment: Moment): RobotState => moment.simulation.robots[0]!

/** Mean set speed of both wheels, without sign. A turn on the spot is not standing still. */
export function speedIn(moment: Moment): Percent {
  const { left, right } = moment.world.robots[0]!.config.drive
  const { motors } = robotIn(moment)
  return (Math.abs(motors[left].percent) + Math.abs(motors[right].percent)) / 2
}

/** From the middle of the robot's axle to a point. */
export function awayFrom(moment: Moment, x: Cm, y: Cm): Cm {
  const robot = robotIn(moment)
  const [dx, dy] = [robot.x - x, robot.y - y]
  return Math.sqrt(dx * dx + dy * dy)
}

/** What the robot's first sensor of a kind reads; null without such a sensor. */
export function readingOf(moment: Moment, kind: SensorKind, mode: ReadMode): number | Colour | null {
  const sensors = Object.entries(moment.world.robots[0]!.config.sensors)
  const port = sensors.find(([, sensor]) => sensor.kind === kind)?.[0]
  return port === undefined ? null : moment.read(0, port as SensorPort, mode)
}

/** What the robot's first colour sensor sees: '' for none of the eight, null without such a sensor. */
export const colourUnder = (moment: Moment): Colour | null =>
  readingOf(moment, 'colour', 'colour') as Colour | null

/** From the robot's front edge to the outline of an obstacle, 0 inside it; null if there is no such obstacle. */
export function gapIn(moment: Moment, obstacleId: string): Cm | null {
  const index = moment.world.obstacles.findIndex(({ id }) => id === obstacleId)
  const state = moment.simulation.obstacles[index]
  if (!state) return null
  const robot = robotIn(moment)
  const x = robot.x + FRONT * cos(robot.heading)
  const y = robot.y + FRONT * sin(robot.heading)
  return distanceTo(moment.world.obstacles[index]!.shape, state, x, y)
}

function distanceTo(shape: Shape, at: ObstacleState, x: Cm, y: Cm): Cm {
  const c = cos(at.heading)
  const s = sin(at.heading)
  const dx = x - at.x
  const dy = y - at.y
  const ahead = Math.abs(c * dx + s * dy)
  const aside = Math.abs(c * dy - s * dx)
  if (shape.kind === 'circle') return Math.max(0, Math.sqrt(dx * dx + dy * dy) - shape.radius)
  const over = Math.max(0, ahead - shape.width / 2)
  const beside = Math.max(0, aside - shape.height / 2)
  return Math.sqrt(over * over + beside * beside)
}
