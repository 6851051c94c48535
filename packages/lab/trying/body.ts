import type { Action, Facts, Sensor, Trial } from '@botgarten/learning/q-senses'
import { cos, sin } from '@botgarten/numbers'
import {
  COLOURS,
  setLed,
  setMotor,
  type Cm,
  type Percent,
  type Radians,
  type SensorPort,
  type Simulation,
} from '@botgarten/simulation'

const colours: readonly string[] = Object.values(COLOURS)
/** A distance sensor says no more; beyond is free. */
const farthest = 100
/** Edge of the squares that count as new places. */
const tileCm = 40

/** What of a world a robot's sensors and body are asked for. */
export type Sensing = Pick<Simulation, 'world' | 'state' | 'read'>

/** One reading as buckets take it: cm up to 100, light 0..100, a colour's number 0..7, touch 0 or 1. */
function readingOf(simulation: Sensing, robot: number, { port, mode }: Sensor): number {
  const value = simulation.read(robot, port, mode)
  if (mode === 'colour') return Math.max(0, colours.indexOf(String(value)))
  return Math.min(farthest, Number(value ?? 0))
}

export const readingsOf = (simulation: Sensing, robot: number, { sensors }: Trial): readonly number[] =>
  sensors.map((sensor) => readingOf(simulation, robot, sensor))

export const touchesIn = (simulation: Sensing, robot: number): boolean =>
  simulation.state.robots[robot]!.touching.length > 0

/** Does an action from now on. */
export function drive(simulation: Simulation, robot: number, action: Action): void {
  const { left, right } = simulation.world.robots[robot]!.config.drive
  setMotor(simulation, robot, left, action.left)
  setMotor(simulation, robot, right, action.right)
  if (action.lamp) setLed(simulation, robot, action.lamp === 'off' ? null : action.lamp)
}

/** What of a robot pay may ask for, at one moment. */
export interface Sight {
  readonly x: Cm
  readonly y: Cm
  readonly heading: Radians
  /** Mean turning of both wheels, degrees. */
  readonly turned: number
  /** How far each distance sensor sees, cm. */
  readonly eyes: readonly Cm[]
  /** 0..100; null without a colour sensor. */
  readonly light: Percent | null
  readonly touches: boolean
}

export function sightOf(simulation: Sensing, robot: number): Sight {
  const { x, y, heading, motors } = simulation.state.robots[robot]!
  const { sensors, drive } = simulation.world.robots[robot]!.config
  const ports = (kind: string) =>
    (Object.keys(sensors) as SensorPort[]).filter((port) => sensors[port]!.kind === kind).sort()
  const [floor] = ports('colour')
  return {
    ...{ x, y, heading },
    turned: (motors[drive.left].turned + motors[drive.right].turned) / 2,
    eyes: ports('ultrasonic').map((port) => readingOf(simulation, robot, { port, mode: 'distance' })),
    light: floor === undefined ? null : readingOf(simulation, robot, { port: floor, mode: 'light' }),
    touches: touchesIn(simulation, robot),
  }
}

/** The square of the floor on which it stands, as one number. */
export const tileAt = ({ x, y }: Sight): number => Math.floor(x / tileCm) + 1000 * Math.floor(y / tileCm)

/** What happened from one decision to the next. `bumped`: the body touched in one of its ticks; `isNew`: a tile of this try. */
export function factsOf(before: Sight, now: Sight, bumped: boolean, isNew: boolean): Facts {
  const [dx, dy] = [now.x - before.x, now.y - before.y]
  const middle = before.heading + turnOf(before, now) / 2
  const seen = sum(now.eyes)
  const nearest = Math.min(farthest, ...now.eyes)
  const isDark = now.light !== null && now.light < 30
  return {
    bump: Number(bumped),
    moment: 1,
    ahead: dx * cos(middle) + dy * sin(middle),
    way: Math.sqrt(dx * dx + dy * dy),
    wheels: Math.max(0, now.turned - before.turned) / 90,
    farther: Math.max(0, seen - sum(before.eyes)) / 20,
    open: seen / (farthest * Math.max(1, now.eyes.length)),
    near: Number(!bumped && nearest > 5 && nearest < 30),
    tile: Number(isNew),
    black: Number(isDark),
    line: Number(isDark && (before.light ?? 0) >= 70),
    free: Number(before.touches && !now.touches),
  }
}

const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0)

/** How far it has turned, the short way round. */
function turnOf(before: Sight, now: Sight): Radians {
  const turn = now.heading - before.heading
  if (turn > Math.PI) return turn - 2 * Math.PI
  return turn < -Math.PI ? turn + 2 * Math.PI : turn
}
