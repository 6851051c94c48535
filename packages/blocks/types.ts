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

// ---- a program as data ----

/** One block. Rows are flat, as in Open Roberta: what follows a block stands after it in the same list. */
export interface Block {
  readonly id: string
  readonly type: string
  readonly fields?: { readonly [name: string]: string }
  readonly mutation?: Mutation
  readonly values?: { readonly [name: string]: Block }
  readonly statements?: { readonly [name: string]: readonly Block[] }
  readonly comment?: string
  readonly data?: string
  readonly hide?: readonly string[]
  readonly disabled?: boolean
  readonly collapsed?: boolean
  readonly inline?: boolean
  readonly shadow?: boolean
  readonly flags?: { readonly [name: string]: string }
}

export interface Mutation {
  readonly attrs: { readonly [name: string]: string }
  readonly args?: readonly { readonly name: string; readonly type: string }[]
}

/** A block as it comes from the toolbox: without an id, with what is plugged in. */
export type Template = Omit<Block, 'id' | 'values' | 'statements'> & {
  readonly values?: { readonly [name: string]: Template }
  readonly statements?: { readonly [name: string]: readonly Template[] }
}

/** Colours are `#RRGGBB` in upper case. */
export type Value = number | string | boolean | null | Order | readonly Value[]

/** What an output neuron wants done with its value. The network block carries the orders out together. */
export type Order =
  | { readonly order: 'motor'; readonly port: MotorPort; readonly level: number }
  | { readonly order: 'led'; readonly colour: LedColour; readonly level: number }
  | { readonly order: 'text'; readonly text: string; readonly level: number }
  | { readonly order: 'sound'; readonly level: number }

export type ValueType =
  | 'Number'
  | 'String'
  | 'Boolean'
  | 'Colour'
  | 'InputNode'
  | 'OutputNode'
  | 'InputLayer'
  | 'OutputLayer'
  /** A road that is closed, and a list of them. */
  | 'Obstacle'
  | 'ObstacleList'

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
  led(colour: LedColour | null): void
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

export interface Context {
  readonly robot: Robot
  /** Seconds of simulated time since the run began. */
  readonly now: Seconds
  /** One run of the brain that belongs to the network block with this id. */
  think(networkId: string, inputs: readonly number[]): readonly number[]
}

// ---- how a block runs: data in, data out ----

/** One block that is being carried out. `got`: values that its inputs have given so far. */
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
  /** Carry out the block in a value input; its value is added to `got`. `given` stands in the child's `got` at its start (copied). */
  | { readonly next: 'value'; readonly input: string; readonly given?: readonly Value[] }
  /** Carry out the blocks in a statement input, then come back. */
  | { readonly next: 'statements'; readonly input: string }
  /** This block is done; a value block hands up its value. */
  | { readonly next: 'done'; readonly value?: Value }
  /** Come back to this frame in the same tick (a loop's back edge: running.md 3). */
  | { readonly next: 'again' }
  /** Come back in a later tick. */
  | { readonly next: 'wait' }
  /** The block cannot go on: the program stops safely and the screen says why at the block. */
  | { readonly next: 'fail'; readonly problem: string; readonly facts?: Facts }

export type Facts = { readonly [name: string]: string | number }

// ---- one block, one file ----

export type Category = 'control' | 'action' | 'sensors' | 'logic' | 'math' | 'text' | 'network' | 'q-learning'

export type FieldLook =
  | {
      readonly name: string
      readonly kind: 'number'
      readonly preset: number
      readonly min?: number
      readonly max?: number
      readonly step?: number
    }
  | { readonly name: string; readonly kind: 'text'; readonly preset: string }
  /** A drop-down. `words` of an option: a message key, or null where the value itself is shown ("2", "C"). `dot`: a colour shown as a ringed dot. */
  | {
      readonly name: string
      readonly kind: 'choice'
      readonly preset: string
      readonly options: readonly {
        readonly value: string
        readonly words: string | null
        readonly dot?: Colour
      }[]
      /** Any number in this range may stand there too; it is shown as it is. */
      readonly numbers?: { readonly min: number; readonly max: number }
    }
  /** In the file, never on the block. */
  | { readonly name: string; readonly kind: 'hidden'; readonly preset: string }

export type InputLook =
  | {
      readonly name: string
      readonly kind: 'value'
      readonly accepts: readonly ValueType[]
      /** The block runs without it, or says itself what is missing. */
      readonly optional?: true
    }
  | { readonly name: string; readonly kind: 'statements' }

/** Shape as data. No functions, no sentences, no colours written out. */
export interface Look {
  readonly category: Category
  /** hat: starts a program · statement: has a row before and after · value: is plugged in. */
  readonly shape: 'hat' | 'statement' | 'value'
  readonly output?: ValueType
  readonly icon?: 'play' | 'network' | 'repeat' | 'map' | 'gear'
  readonly fields: readonly FieldLook[]
  readonly inputs: readonly InputLook[]
  /** A list that grows: `items` rows `ADD0…`, each with its own minus, a plus at the foot (mutation `items`). */
  readonly items?: { readonly prefix: 'ADD'; readonly min: number; readonly max: number }
  /** Message keys, one a row of the block; `{NAME}` in the message is where a field, an input or the {ICON} stands. */
  readonly rows: readonly string[]
  /** What the block always writes into its mutation besides `items`: a constant, or what one of its fields says. */
  readonly mutation?: { readonly [attribute: string]: string | { readonly field: string } }
  /** Faces of one type, told apart by a field or an attribute of the mutation. The look itself shows the preset's face. */
  readonly faces?: Faces
}

export interface Faces {
  readonly by: { readonly field: string } | { readonly attribute: string }
  readonly of: { readonly [value: string]: Face }
}

export interface Face {
  readonly output: ValueType
  /** Form of the plug; round where nothing is said. */
  readonly plug?: 'pointed' | 'round'
  /** Colour of the plug and of the list's edge. */
  readonly tint?: 'sensor' | 'actuator'
  readonly items?: {
    readonly accepts: readonly ValueType[]
    /** Message key beside the plus at the foot. */
    readonly add: string
    /** What a new row comes with. */
    readonly fresh: Template
  }
}

/** A neuron block: what the playground writes beside its node and how it colours it. */
export interface NeuronLook {
  readonly layer: 'input' | 'output'
  /** Message key; gets the block's fields as parameters, as they are shown ("2", "green"). */
  readonly label: string
  /** Field that names the port, where there is one. */
  readonly port?: string
  /** `sensor` teal, `actuator` apricot, or the colour that stands in a field. */
  readonly colour: 'sensor' | 'actuator' | { readonly field: string }
  readonly sensor?: SensorKind
}

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
   * Ways out: setting a field of the block to a value mends it, with `plug` when such a sensor is plugged in there first.
   * `words`: message key for the button, with its facts.
   */
  readonly fixes?: readonly {
    readonly field: string
    readonly value: string
    readonly words: string
    readonly facts?: Facts
    readonly plug?: { readonly port: SensorPort; readonly kind: SensorKind }
  }[]
  /** false: the program can run all the same (a hint). */
  readonly stops: boolean
}

/** What a check may look at: the block itself and the robot's sockets. */
export interface CheckContext {
  readonly sensors: { readonly [port in SensorPort]?: { readonly kind: SensorKind } }
}

export interface Definition {
  readonly type: string
  readonly look: Look
  /** Message keys: `help` is one sentence for the child. */
  readonly words: { readonly help: string; readonly name: string }
  readonly neuron?: NeuronLook
  /** Where a finding names no block, this one is meant. */
  check?(
    block: Block,
    context: CheckContext,
  ): readonly (Omit<Finding, 'block'> & { readonly block?: string })[]
  run(block: Block, frame: Frame, context: Context): Next
  /** Does it sense, drive, show, sound or run a net? (running.md 3) */
  readonly acts: boolean
  /** A whole small program around the block that runs, for help and for the contract tests. */
  readonly example: readonly Template[]
}
