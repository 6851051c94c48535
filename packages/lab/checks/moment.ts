import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { TableBrain } from '@botgarten/learning/q-senses'
import { cos, sin } from '@botgarten/numbers'
import type { LearningOutline, Raced } from '@botgarten/programs'
import {
  FRONT,
  type Cm,
  type Colour,
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
   * of its sensors seen what the one on the other side sees; `thinks` false: had its networks put out 0. null where it would
   * set no wheel.
   */
  nextTurn(mirrored: boolean, thinks?: boolean): Percent | null
  /** The first network of the first robot, with what it was shown; null where it has none. */
  readonly taught: Brain | null
  /** Does the first robot learn by trying in this tick? What it does then is no result. */
  readonly trying: boolean
  /** The learned table by which the first robot drives; null: it drives by none. */
  readonly table: TableBrain | null
  /** What came of the project's last race of brains; null: there was none. */
  readonly raced: Raced | null
  /** Roads that the first robot's program closes on its map, from station to station. */
  readonly closed: LearningOutline['closed']
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

/** The middle of the robot's front edge, in cm. */
export function frontOf(moment: Moment): { readonly x: Cm; readonly y: Cm } {
  const robot = robotIn(moment)
  return { x: robot.x + FRONT * cos(robot.heading), y: robot.y + FRONT * sin(robot.heading) }
}

/** From the robot's front edge to the outline of an obstacle, 0 inside it; null if there is no such obstacle. */
export function gapIn(moment: Moment, obstacleId: string): Cm | null {
  const to = gapTo(moment, obstacleId)
  const { x, y } = frontOf(moment)
  return to && Math.sqrt((to.x - x) * (to.x - x) + (to.y - y) * (to.y - y))
}

/** The point of an obstacle that is nearest to the robot's front edge; null if there is no such obstacle. */
export function gapTo(moment: Moment, obstacleId: string): { readonly x: Cm; readonly y: Cm } | null {
  const index = moment.world.obstacles.findIndex(({ id }) => id === obstacleId)
  const at = moment.simulation.obstacles[index]
  if (!at) return null
  const from = frontOf(moment)
  const [c, s] = [cos(at.heading), sin(at.heading)]
  const [dx, dy] = [from.x - at.x, from.y - at.y]
  const [ahead, aside] = nearestOf(moment.world.obstacles[index]!.shape, c * dx + s * dy, c * dy - s * dx)
  return { x: at.x + c * ahead - s * aside, y: at.y + s * ahead + c * aside }
}

/** The point of a shape about its middle that is nearest to `ahead`, `aside`: that point itself where it lies inside. */
function nearestOf(shape: Shape, ahead: Cm, aside: Cm): readonly [ahead: Cm, aside: Cm] {
  if (shape.kind === 'circle') {
    const away = Math.sqrt(ahead * ahead + aside * aside)
    const share = away > shape.radius ? shape.radius / away : 1
    return [ahead * share, aside * share]
  }
  const within = (at: Cm, half: Cm) => Math.min(half, Math.max(0 - half, at))
  return [within(ahead, shape.width / 2), within(aside, shape.height / 2)]
}
