// Units are written into the types. The brands are optional: a plain number may be given, but two units do not mix.
export type Cm = number & { readonly unit?: 'cm' }
export type Degrees = number & { readonly unit?: 'degrees' }
export type Radians = number & { readonly unit?: 'radians' }
/** −100..100 for motors, 0..100 for readings. */
export type Percent = number & { readonly unit?: 'percent' }
export type Seconds = number & { readonly unit?: 'seconds' }
export type Hertz = number & { readonly unit?: 'hertz' }

/** running.md 1: origin bottom left, x right, y up; heading 0 = east, counter-clockwise positive. */
export interface Pose {
  readonly x: Cm
  readonly y: Cm
  readonly heading: Degrees
}

/** `#RRGGBB`, upper case. */
export type Colour = string

export type Shape =
  | { readonly kind: 'rectangle'; readonly width: Cm; readonly height: Cm }
  /** `tip`: how far to the right of the middle its tip is; 0 where it is not said. */
  | { readonly kind: 'triangle'; readonly width: Cm; readonly height: Cm; readonly tip?: Cm }
  | { readonly kind: 'circle'; readonly radius: Cm }

/** A body on the floor. `look` names a drawing of the app and has no meaning here. */
export interface Obstacle {
  readonly id: string
  readonly shape: Shape
  readonly pose: Pose
  readonly fixed: boolean
  readonly colour: Colour
  readonly look?: string
}

/** A colour on the floor, without a body. */
export interface Area {
  readonly id: string
  readonly shape: Shape
  readonly pose: Pose
  readonly colour: Colour
}

/** A line on the floor: points in cm joined by strokes of one width. */
export interface Line {
  readonly id: string
  readonly points: readonly { readonly x: Cm; readonly y: Cm }[]
  readonly width: Cm
  readonly colour: Colour
}

export type SensorPort = '1' | '2' | '3' | '4'
export type MotorPort = 'A' | 'B' | 'C' | 'D'
export type SensorKind =
  'ultrasonic' | 'colour' | 'touch' | 'gyro' | 'infrared' | 'sound' | 'compass' | 'position' | 'irseeker'
/** The keys on the robot's own panel. */
export type RobotKey = 'enter' | 'up' | 'down' | 'left' | 'right' | 'escape'

/** Where a sensor sits: x forward and y left of the middle of the axle, `angle` counter-clockwise from straight ahead. */
export interface SensorPlace {
  readonly kind: SensorKind
  readonly x: Cm
  readonly y: Cm
  readonly angle: Degrees
  /** Whose it is; LEGO's where nothing is said. It reads alike. */
  readonly maker?: 'hitechnic'
}

/** What is plugged in at a motor port. Only large motors drive wheels. */
export interface MotorPlug {
  readonly kind: 'large' | 'medium' | 'other'
  /** Turns the other way. Of the left wheel's motor: what drives, turns or curves goes the other way. */
  readonly reversed?: true
  /** Says nothing here; a real motor without it is slower under load. */
  readonly unregulated?: true
}

export interface RobotConfig {
  readonly wheelDiameter: Cm
  readonly trackWidth: Cm
  readonly sensors: { readonly [port in SensorPort]?: SensorPlace }
  /** Which motors drive the wheels. */
  readonly drive: { readonly left: MotorPort; readonly right: MotorPort }
  /** What is plugged in, port by port. Not given: large motors drive the wheels, the other ports are empty. */
  readonly motors?: { readonly [port in MotorPort]?: MotorPlug }
  /** Each reading is multiplied by a uniform draw from 1 ± noise/100. 0 = none. */
  readonly noise?: Percent
  /** So many ticks late do orders reach the motors and readings the program: a whole number, 0..60. 0 = at once. */
  readonly delay?: number
  /** Each wheel turns so much of what it is told: 0.5..1. Not given: both turn all of it. */
  readonly strength?: { readonly left: number; readonly right: number }
}

export interface RobotPlacement {
  readonly id: string
  readonly pose: Pose
  /** Key into the project's programs. */
  readonly program: string
  /** Name of the weight set it drives with; '' = the weights on the knobs. */
  readonly brain: string
  readonly config: RobotConfig
}

export interface World {
  readonly size: { readonly width: Cm; readonly height: Cm }
  /** `asset`: sha-256 of a PNG in the project's assets, or `content:<path>` for one that ships with the product. */
  readonly floor: { readonly asset: string } | { readonly colour: Colour }
  readonly areas: readonly Area[]
  readonly lines: readonly Line[]
  readonly obstacles: readonly Obstacle[]
  readonly robots: readonly RobotPlacement[]
}

/** The floor as sensors see it: rows from the top, three bytes (R, G, B) a pixel. */
export interface Floor {
  readonly width: number
  readonly height: number
  readonly pixelsPerCm: number
  readonly data: Uint8Array
}

export type LedColour = 'green' | 'orange' | 'red'

/** Everything of a robot that changes while it runs. Plain data: a copy of it is the robot at that moment. */
export interface RobotState {
  x: Cm
  y: Cm
  heading: Radians
  /** Set speed of each motor in percent, how far it has turned in degrees, and how far it still has to turn (null: until set again). */
  motors: { [port in MotorPort]: { percent: Percent; turned: Degrees; left: Degrees | null } }
  /** A move that ends by itself: what is left for the two wheels, in degrees of wheel turning, both ≥ 0. */
  move: { left: Degrees; right: Degrees } | null
  led: LedColour | null
  /** How the lamp blinks; null: it stays on. */
  blink: 'flash' | 'double' | null
  /** A picture on the display in place of its rows, by Open Roberta's name. */
  picture: string | null
  /** Rows of the display, 0 at the top. */
  display: string[]
  /** The tone that sounds now. `untilTick` null = until it is changed. */
  tone: { frequency: Hertz; untilTick: number | null } | null
  /** 0..100 */
  volume: Percent
  /** Language it speaks, by Open Roberta's name; '' = that of the page. */
  language: string
  /** What it said last, with the tick in which it began; `speed`, `pitch` 0..100. */
  speech: { text: string; language: string; speed: Percent; pitch: Percent; tick: number } | null
  /** Ids of the obstacles and robots that the body touched in the last tick, and 'edge' for the floor's. */
  touching: string[]
  /** Radians a second that it has turned by in the last tick, counter-clockwise. */
  spin: number
  /** Heading at which the gyro at each port says 0. */
  gyroZero: { [port in SensorPort]: Radians }
  /** Ticks on each of the five timers. */
  timers: number[]
  /** Keys of its panel that are down. */
  keys: RobotKey[]
  /** What is still on its way in a robot with delay, oldest first; null in others. */
  late: Late | null
}

/** Flat rows, one a tick: how far each motor (A to D) shall turn; what each port (1 to 4) has read, three numbers each. */
export interface Late {
  turns: number[]
  readings: number[]
}

export interface ObstacleState {
  id: string
  x: Cm
  y: Cm
  heading: Radians
  /** cm/s, cm/s, rad/s; 0 for fixed ones. */
  vx: number
  vy: number
  spin: number
}

/** The whole physical state, and nothing but data: a keyframe is a structured copy of it (running.md 8). */
export interface SimulationState {
  tick: number
  robots: RobotState[]
  obstacles: ObstacleState[]
  /** The random stream `noise`, as numbers. */
  noise: readonly number[]
}

/** One distance ray from its origin to the first thing it hits (or its end), in cm. */
export interface Ray {
  readonly fromX: Cm
  readonly fromY: Cm
  readonly toX: Cm
  readonly toY: Cm
  readonly distance: Cm
}

export type ReadMode =
  | 'distance'
  | 'light'
  | 'colour'
  | 'red'
  | 'green'
  | 'blue'
  | 'touch'
  | 'angle'
  | 'rate'
  | 'infrared'
  | 'sound'
  | 'compass'
  | 'x'
  | 'y'
  | 'heading'

/** A world in motion. `state` is read by everybody and written only here and through the robot verbs. */
export interface Simulation {
  readonly world: World
  readonly state: SimulationState
  /** Motors, then physics, then readings: one tick of 1/60 s (running.md 2). */
  step(): void
  /**
   * Reading of the sensor at a port; null where there is no such sensor. Colours come as one of the eight names' `#RRGGBB`,
   * '' for none of them (two colours mix on an edge); touch as 0 or 1; angle, rate (a second) and compass in degrees
   * clockwise, 0 on the compass = up (+y); infrared 0..100 over 70 cm; sound 0..100; x, y in cm and heading in degrees as rule 1 has them, heading 0..360.
   */
  readonly read: (robot: number, port: SensorPort, mode: ReadMode) => number | Colour | null
  /** The rays a distance sensor sends now, for the screen. */
  rays(robot: number, port: SensorPort): readonly Ray[]
  /** Puts a robot or an obstacle somewhere by hand; nearest free place on the floor. Returns where it came to stand. */
  place(id: string, pose: Pose): Pose
  /** Puts what overlaps where it must not, or has left the floor, at the nearest free place. */
  settle(): void
  /**
   * A copy of the state that `restore` takes; both go on bit for bit the same (running.md 8). Physics remembers nothing
   * beside the state, so a keyframe may be taken at any tick and taking it changes nothing.
   */
  keyframe(): SimulationState
  restore(state: SimulationState): void
}
