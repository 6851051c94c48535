import type { Look, NeuronLook } from './look.ts'
import type { Block, Template, Value } from './program.ts'
import type { Python } from './python.ts'
import type {
  Colour,
  Degrees,
  Hertz,
  LedColour,
  MotorPort,
  Percent,
  ReadMode,
  RobotKey,
  Seconds,
  SensorKind,
  SensorPort,
} from '@botgarten/simulation'

export type * from './look.ts'
export type * from './program.ts'

// ---- what a block may touch ----

export interface Robot {
  /** null where no such sensor is at the port. */
  read(port: SensorPort, mode: ReadMode): number | Colour | null
  motor(port: MotorPort, percent: Percent): void
  /** Both wheels; with `degrees` the faster wheel turns that far and the move ends by itself. */
  move(order: { left: Percent; right: Percent; degrees?: Degrees }): void
  /** Has the last move with `degrees` ended? */
  arrived(): boolean
  stop(): void
  /** Percent a motor is set to. */
  power(port: MotorPort): Percent
  /** Turns one motor so far (degrees ≥ 0); it stops by itself. */
  turn(port: MotorPort, percent: Percent, degrees: Degrees): void
  /** Has the motor's last turn ended? */
  turned(port: MotorPort): boolean
  /** `blink` not given: it stays on. */
  led(colour: LedColour | null, blink?: 'flash' | 'double'): void
  /** A picture in place of all that is on the display, by Open Roberta's name. */
  picture(name: string): void
  /** 0..100 */
  volume(): Percent
  setVolume(percent: Percent): void
  /** `speed`, `pitch`: 0..100. */
  say(text: string, speed: Percent, pitch: Percent): void
  /** Language of what is said, by Open Roberta's name. */
  language(name: string): void
  /** Replaces what stands in `row` (0..) from `column` on. */
  display(row: number, column: number, text: string): void
  clearDisplay(): void
  /** `seconds` null: until changed. `frequency` 0: silence. */
  tone(frequency: Hertz, seconds: Seconds | null): void
  /** How far a motor has turned since it was set back. */
  encoder(port: MotorPort): Degrees
  resetEncoder(port: MotorPort): void
  /** Whole milliseconds on a timer (1 to 5) since it was set back; null where there is none of this number. */
  timer(number: number): number | null
  resetTimer(number: number): void
  /** From now on the gyro at this port counts from here. */
  resetGyro(port: SensorPort): void
  /** Is this key of the robot's panel down? */
  key(key: RobotKey | 'any'): boolean
  readonly wheelDiameter: number
  readonly trackWidth: number
}

/** What a program is run on. */
export interface Host {
  readonly robot: Robot
  /** Seconds of simulated time since the run began. */
  readonly now: Seconds
  /** One run of the brain that belongs to the network block with this id. */
  readonly think: (networkId: string, inputs: readonly number[]) => readonly number[]
  /** The brain under this id, with the weights this robot drives with. */
  readonly brain?: (id: string) => HostBrain | undefined
  /** Other robots of the same world. Not given: there are none. */
  readonly mail?: Mail
  /** What the program's first network is shown, and its practice. Not given: it can be shown nothing. */
  readonly teaching?: Teaching
  /** What the robot learns by trying. Not given: it can try nothing. */
  readonly trying?: Trying
}

/** Where something cannot be done, its problem's name in the section `problem` of the words comes back. */
export interface Teaching {
  /** One example: what the network reads in this tick, and what the robot does. */
  remember(): string | null
  /** So many rounds are done before the next tick begins. */
  practise(rounds: number): string | null
  forget(what: 'examples' | 'practice'): void
  /** How far the network is off its examples, in percent. */
  error(): number | string
}

/** Where something cannot be done, its problem's name in the section `problem` of the words comes back. */
export interface Trying {
  /** One tick of trying, as the program's blocks say. true: it has tried for long enough. */
  learn(): boolean | string
  /** Does what the table holds for the best now; for how many ticks that is held. */
  act(): number | string
}

/** As much of a brain as blocks look at: neurons' names and biases by layer from the inputs on, weights by name. */
export interface HostBrain {
  readonly layers: readonly (readonly { readonly id: string; readonly bias: number }[])[]
  readonly weights: { readonly [from: string]: { readonly [to: string]: number } }
}

/** Messages between robots. A robot is named by its id in the world. */
export interface Mail {
  /** The id of another robot that goes by this name; null where there is none. */
  find(name: string): string | null
  send(to: string, letter: Omit<Letter, 'from'>): void
}

/** What lies in a robot's letter box. `call`: a robot wants to be connected. */
export interface Letter {
  readonly from: string
  readonly kind: 'call' | 'text'
  readonly text: string
}

/** What a block may touch while it runs. */
export interface Context extends Host {
  readonly memory: Memory
}

/** What the program itself remembers: it belongs to the thread. */
export interface Memory {
  /** undefined where no variable of this name is there. */
  get(name: string): Value | undefined
  /** Sets the variable where it was made; false where there is none of this name. */
  set(name: string, value: Value): boolean
  /** Makes a variable: of the function that runs, else of the whole program. */
  make(name: string, value: Value): void
  /** Uniform in [0, 1), from the run's seed. */
  random(): number
  /** The two values that were compared last, for assertions. */
  compared: readonly [Value, Value] | null
  assert(assertion: Assertion): void
  debug(block: string, text: string): void
  /** Id of the block that carries the network of the `robActions_NNstep` family. */
  readonly networkId: string
  net(): NetMemory
  letters(): Letter[]
  /** What the blocks of sorting have collected; they write into it. */
  sorting(): SortingMemory
}

/** What a program has collected and sorted. Plain data, part of its thread. */
export interface SortingMemory {
  /** Rows of red, green and blue. */
  readings: (readonly number[])[]
  /** How many there were, those included whose places others have taken. */
  collected: number
  /** Middles of the groups, in the order in which they were met; empty until groups were found. */
  centres: (readonly number[])[]
  names: string[]
}

/** What a block `robActions_assert` found out. `expected`, `got`: texts of the two values of a comparison, else of the truth. */
export interface Assertion {
  readonly id: string
  readonly text: string
  readonly expected: string
  readonly got: string
  readonly passed: boolean
}

/** The network of the `robActions_NNstep` family while it runs: what blocks have changed of its brain. By neurons' names. */
export interface NetMemory {
  inputs: { [name: string]: number }
  outputs: { [name: string]: number }
  weights: { [from: string]: { [to: string]: number } }
  biases: { [name: string]: number }
}

// ---- how a block runs: data in, data out ----

/** One block that is being executed. `got`: values that its inputs have given so far. */
export interface Frame {
  block: string
  stage: number
  got: Value[]
  counter?: number
  /** Of a loop: the thread's count of acts when this pass began (running.md 3). Kept by the interpreter. */
  mark?: number
}

/** What the interpreter does next. */
export type Next =
  /** Execute the block in a value input; its value is added to `got`. `given` stands in the child's `got` at its start (copied). */
  | { readonly next: 'value'; readonly input: string; readonly given?: readonly Value[] }
  /** Execute the blocks in a statement input, then come back. */
  | { readonly next: 'statements'; readonly input: string }
  /** This block is done; a value block hands up its value. `cost`: blocks of the tick's budget it took besides its own. */
  | { readonly next: 'done'; readonly value?: Value; readonly cost?: number }
  /** Execute a function of the program; what it gives is added to `got`. */
  | { readonly next: 'call'; readonly name: string; readonly args: readonly Value[] }
  /** Leave the function that runs. */
  | { readonly next: 'return'; readonly value?: Value }
  /** Leave the innermost loop, or its pass. */
  | { readonly next: 'leave'; readonly how: 'loop' | 'pass' }
  /** Come back to this frame in the same tick (a loop's back edge: running.md 3). */
  | { readonly next: 'again' }
  /** Come back in a later tick. */
  | { readonly next: 'wait' }
  /** The block cannot go on: the program stops safely and the screen says why at the block. */
  | { readonly next: 'fail'; readonly problem: string; readonly facts?: Facts }

export type Facts = { readonly [name: string]: string | number }

// ---- one block, one file ----

/**
 * Something a child should change before the program runs, said at the block. `problem` is `problem.<name>`; its words
 * are the messages `<problem>.title` and `<problem>.text` (what to try), both with `facts` as parameters.
 */
export interface Finding {
  /** '' where the whole program is meant. */
  readonly block: string
  readonly problem: string
  readonly facts?: Facts
  /**
   * Ways out: setting a field of the block to a value fixes it, with `plug` when such a sensor is plugged in there first.
   * `words`: message key for the button, with its facts.
   */
  readonly fixes?: readonly {
    readonly field: string
    readonly value: string
    readonly words: string
    readonly facts?: Facts
    readonly plug?: { readonly port: SensorPort; readonly kind: SensorKind }
  }[]
  /** The way out is to put the block among those that run: message key for the button. */
  readonly putIn?: string
  /** false: the program can run all the same (a hint). */
  readonly stops: boolean
  /** It is about the real robot alone: its badge looks different. */
  readonly mark?: 'robot'
}

/** What a check may look at: the block itself and the robot's sockets. */
export interface CheckContext {
  /** Stations of the project's own maps, by their ids. */
  readonly maps?: { readonly [id: string]: number }
  readonly sensors: { readonly [port in SensorPort]?: { readonly kind: SensorKind } }
}

/** What a check finds at a block. */
export type CheckFinding = Omit<Finding, 'block'> & { readonly block?: string }

/**
 * What comes when: `core` is what most cards need, and is there at once; `learning` are deeper networks, maps and sorting;
 * `expert` is the rest of Open Roberta's language.
 */
export type Pack = 'core' | 'learning' | 'expert'

export interface Definition {
  readonly type: string
  /** The pack that loads the block. `npm run blocks` writes the packs' tables from this field. */
  readonly pack: Pack
  /** Not in the toolbox: only `old` files hold it, or the `program` decides which ones there are (its variables, its functions). */
  readonly outsideToolbox?: 'old' | 'program'
  readonly look: Look
  /** Of a block of the cards: what is different about it where the expert pack is loaded. */
  readonly expertLook?: Partial<Look>
  /** Message keys: `help` is one sentence for the child. */
  readonly words: { readonly help: string; readonly name: string }
  readonly neuron?: NeuronLook
  /** Where a finding names no block, this one is meant. */
  check?(block: Block, context: CheckContext): readonly CheckFinding[]
  /** Blocks that are written in the block as text: they stand in its inputs. An error is a key of the section `problem`. */
  written?(
    block: Block,
  ): { readonly values: { readonly [input: string]: Block } } | { readonly error: CheckFinding }
  run(block: Block, frame: Frame, context: Context): Next
  /** A loop: "leave the loop" ends it. */
  readonly loops?: true
  /** Does it sense, drive, show, sound or run a net? (running.md 3) */
  readonly acts: boolean
  /** What of the robot it shows or sounds with. */
  readonly uses?: 'lamp' | 'display' | 'sound' | 'speech'
  /** What it is in Python, for both robots' libraries. */
  readonly python: Python
  /** A whole small program around the block that runs, for help and for the contract tests. */
  readonly example: readonly Template[]
}
