import type { Colour, MotorPort, RobotKey, SensorKind, SensorPort } from '@botgarten/simulation'
import type { Block, Facts, ValueType } from './types.ts'

/** How tightly an expression of Python binds, from loose to tight (Python reference, 6.17 "Operator precedence"). */
export const binds = {
  any: 0,
  ternary: 1,
  or: 2,
  and: 3,
  not: 4,
  compare: 5,
  sum: 6,
  product: 7,
  sign: 8,
  power: 9,
  whole: 10,
} as const

/** `not`: the same turned round, where Python has an operator for it (`<` and `>=`). */
export interface Expression {
  readonly code: string
  readonly binds: number
  readonly not?: string
}

export const whole = (code: string): Expression => ({ code, binds: binds.whole })

/**
 * What a block is in Python: a value block gives an expression, a statement block writes lines. `missing`: no robot has
 * it, and why (key in the section `python.missing`). `part`: another block writes it, or the head of the file.
 */
export type Python =
  ((py: PythonAt) => Expression | void) | { readonly missing: string } | { readonly part: true }

/** Where a block stands in the file that is written, with what it may ask for. */
export interface PythonAt {
  readonly block: Block
  readonly robot: RobotPython
  field(name: string, preset?: string): string
  /** What is plugged in. A gap ends the statement. */
  expression(input: string): Expression
  /** The same as code, in brackets where it binds looser than `least`. */
  value(input: string, least?: number): string
  kind(input: string): ValueType | 'any'
  /** A value as the display shows it. */
  text(input: string, least?: number): string
  /** A text of the child's as Python writes it. */
  quote(text: string): string
  line(code: string): void
  comment(text: string): void
  /** Writes one step further in. */
  inner(write: () => void): void
  /** What stands in a statement input, where the block itself stands. */
  body(input: string): void
  /** The only block in a statement input, where it is one of these types and `attempt` can be written; else null. */
  alone(input: string, types: readonly string[], attempt: (inner: PythonAt) => unknown): PythonAt | null
  /** `head` and under it what stands in a statement input. */
  rows(head: string, input: string): void
  /** The same for a loop; `last`: what ends every pass. */
  loop(head: string, input: string, last?: readonly string[]): void
  /** What ends a pass of the innermost loop: it has to stand before a `continue`, too. */
  endings(): readonly string[]
  /** Does a loop's variable belong to the loop alone, so that `range` may count it? */
  counts(variable: string): boolean
  /** The name of something of a module, which is imported. */
  from(module: 'math' | 'random', name: string): string
  /** A call of Python's own function, or of one that the file brings along. */
  call(name: string, ...args: readonly string[]): string
  variable(name: string): string
  func(name: string): string
  /** A name that nothing else in the file has. */
  fresh(name: string): string
  /** The same block in the words of another one. */
  as(block: Block): Expression | void
  /** The brick cannot do it: said in the file and at the block. A value block gives nothing of its kind. */
  missing(key: string): Expression
  /** Here stands nothing that could run: key of a problem. */
  gap(problem: string, facts?: Facts): never
  /** Is the robot to go on learning by trying? */
  readonly learner: boolean
  /** Reads, runs and obeys the network of this block. */
  network(): void
  /** One decision by the table that was learned with the robot's sensors. */
  table(): void
  /** A robot that is to learn by itself goes on trying. */
  tryOn(): void
  /** One run of the network that is known by its neurons' names. */
  step(): void
  /** Where a number of that network is kept. */
  neuron(what: 'inputs' | 'outputs' | 'biases' | 'weights', ...names: readonly string[]): string
  /** What the blocks of sorting remember. */
  sorting(what: 'readings' | 'centres' | 'names'): string
}

/** Statements of one robot's library as code; null where its brick cannot do it. */
export interface RobotPython {
  drive(left: string, right: string): string
  /** Both wheels alike. */
  forward(percent: string): string
  /** Turns on the spot to the right. */
  spin(percent: string): string
  straight(percent: string, cm: string): string
  turn(percent: string, degrees: string): string
  curve(left: string, right: string, cm: string): string
  stop(): string
  motor(port: MotorPort, percent: string): string
  motorFor(port: MotorPort, percent: string, degrees: string): string
  motorStop(port: MotorPort, rolls: boolean): string
  power(port: MotorPort): Expression
  encoder(port: MotorPort): Expression
  /** cm that a wheel goes in so many degrees. */
  way(degrees: string): string
  resetEncoder(port: MotorPort): string
  /** `what`: distance (cm), presence, colour, light, ambient, rgb, pressed, angle, rate, nearness, sound. */
  read(kind: SensorKind, port: SensorPort, what: string): Expression | null
  resetGyro(port: SensorPort): string
  timer(number: string): Expression
  resetTimer(number: string): string
  key(key: RobotKey | 'any'): Expression | null
  lamp(colour: string | null, mode: string): string
  lampColour(colour: string): string
  show(text: string, column: string, row: string): string
  clear(): string
  tone(hertz: string, milliseconds: string): string
  setVolume(percent: string): string
  volume(): Expression
  say(text: string, speed?: string, pitch?: string): string | null
  colour(colour: Colour): string
  wait(milliseconds: string): string
}
