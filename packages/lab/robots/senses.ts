import {
  MODES_OF,
  timer,
  type Colour,
  type Degrees,
  type MotorPort,
  type Percent,
  type ReadMode,
  type RobotKey,
  type SensorKind,
  type SensorPort,
  type Simulation,
} from '@botgarten/simulation'

/** What one sensor says, by what it can be asked for. */
export interface PortSense {
  readonly port: SensorPort
  readonly kind: SensorKind
  readonly values: { readonly [mode in ReadMode]?: number | Colour | null }
}

/** Everything a robot senses at a moment. */
export interface Senses {
  readonly ports: readonly PortSense[]
  readonly motors: readonly {
    readonly port: MotorPort
    readonly percent: Percent
    readonly turned: Degrees
  }[]
  /** Milliseconds on the five timers. */
  readonly timers: readonly number[]
  readonly keys: readonly RobotKey[]
}

/** Reading changes nothing: who looks sees what the program would read. */
export function sensesOf(simulation: Simulation, robot: number): Senses {
  const state = simulation.state.robots[robot]
  if (!state) return { ports: [], motors: [], timers: [], keys: [] }
  const { sensors } = simulation.world.robots[robot]!.config
  const motors = Object.entries(state.motors) as [MotorPort, { percent: Percent; turned: Degrees }][]
  return {
    ports: (Object.keys(sensors) as SensorPort[])
      .sort()
      .map((port) => portSense(simulation, robot, port, sensors[port]!.kind)),
    motors: motors.map(([port, { percent, turned }]) => ({ port, percent, turned })),
    timers: state.timers.map((_, index) => timer(simulation, robot, index + 1) ?? 0),
    keys: state.keys,
  }
}

function portSense(simulation: Simulation, robot: number, port: SensorPort, kind: SensorKind): PortSense {
  const values = MODES_OF[kind].map((mode) => [mode, simulation.read(robot, port, mode)])
  return { port, kind, values: Object.fromEntries(values) as PortSense['values'] }
}
