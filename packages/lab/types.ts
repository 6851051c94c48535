import type { Brain, NetTrace } from '@botgarten/learning/neural-network/brain'
import type { Finding } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import type { Floor, LedColour, Pose, Ray, RobotKey, SensorPort } from '@botgarten/simulation'
import type { DriveKey, Hand, Recording, Remembered, TrainingChange, Wheels } from './inputs/input.ts'
import type { Senses } from './robots/senses.ts'
import type { TryView } from './trying/shown.ts'
import type { Variable } from './variables.ts'
import type { Moment } from './timeline/moment.ts'

/** What a lab runs: the parts of a project that behave. */
export type Document = Pick<Project, 'programs' | 'world' | 'brains' | 'tables' | 'raced'>

export interface Check {
  readonly id: string
  readonly kind: string
  readonly numbers: { readonly [name: string]: number | string }
  /** How long it has to hold, or the time within which it must happen. */
  readonly seconds: number
}

export interface CheckResult {
  readonly id: string
  readonly passed: boolean
  /** Simulated second at which it passed last; null while it has not. */
  readonly at: number | null
}

/** What a check that is still open lacks, measured; the screen has a sentence for each `kind` and `what`. */
export interface Missing extends Lack {
  /** Id and kind of the check. */
  readonly check: string
  readonly kind: string
}

export interface Lack {
  /** One of the kind's `lacks`. */
  readonly what: string
  /** By name. cm: `away` · seconds: `seconds`, `needed` · percent: `speed`, `least`, `most` · `colour`: `#RRGGBB` · `thing`: id of an obstacle. */
  readonly facts: { readonly [name: string]: number | string }
  /** From the robot to where it should have been, in cm on the floor. */
  readonly gap?: { readonly from: Place; readonly to: Place }
  /** Nothing that comes later can make up for it. */
  readonly broken?: boolean
}

interface Place {
  readonly x: number
  readonly y: number
}

export type Phase = 'ready' | 'running' | 'paused' | 'ended'

/** What is being recorded at the moment that is shown. */
export interface RecordingView {
  readonly robot: string
  readonly network: string
  /** Id of the drive; it is in the table as soon as it has a row. */
  readonly drive: string
  /** There is no room for more: nothing is written any more. */
  readonly full: boolean
}

export interface TrailPoint {
  readonly t: number
  readonly x: number
  readonly y: number
  readonly heading: number
}

export interface Tone {
  readonly t: number
  /** Hertz; 0 = silence begins. */
  readonly frequency: number
}

export interface RobotView {
  readonly id: string
  readonly pose: Pose
  /** Percent. */
  readonly motors: { readonly [port: string]: number }
  readonly led: LedColour | null
  readonly display: readonly string[]
  readonly frequency: number | null
  /** What it is saying, for as long as that takes. */
  readonly speech: string | null
  readonly touching: readonly string[]
  /** How often it has begun to touch something since Start. */
  readonly bumps: number
  /** Does it learn by trying in this tick? */
  readonly trying: boolean
  /** Of the distance sensors, ultrasonic and infrared; empty for others. */
  readonly rays: { readonly [port in SensorPort]?: readonly Ray[] }
  readonly trail: readonly TrailPoint[]
  readonly tones: readonly Tone[]
  readonly lit: string | null
  readonly problem: Finding | null
}

/** A hand has turned a knob or moved a thing, from one tick to another without a longer pause. */
export interface Mark {
  readonly kind: 'weight' | 'place'
  readonly from: number
  readonly to: number
}

/** The run as a line of time, in ticks since its Start (running.md 9). */
export interface TimeView {
  /** The oldest moment that is kept: ten simulated minutes back at most. */
  readonly first: number
  /** The present. */
  readonly now: number
  /** Is a moment of the past shown, that is: not the present? */
  readonly past: boolean
  /** The same array until there is another mark. */
  readonly marks: readonly Mark[]
  /** Where the robots stand at present while a moment of the past is shown, else empty. */
  readonly present: readonly { readonly id: string; readonly pose: Pose }[]
  /** Is there another future that could come back? */
  readonly other: boolean
}

/**
 * A network opened. `ran`: its last run, term by term as it was. Else what a run would give: while no program runs, with what
 * the sensors say now; in a pause in which a weight has changed since the last run, with what that run read.
 */
export interface NetView extends NetTrace {
  readonly ran: boolean
  /** What it is opened with. */
  readonly brain: Brain
}

/** What the screen shows, asked for once a frame. */
export interface View {
  readonly phase: Phase
  readonly tick: number
  readonly seconds: number
  readonly robots: readonly RobotView[]
  readonly obstacles: readonly { readonly id: string; readonly pose: Pose }[]
  readonly time: TimeView
  /** The brains as they are, or were, at the moment that is shown. */
  readonly brains: { readonly [networkId: string]: Brain }
  /** Of one robot, by network block. A network that has not run since Start is not among them. */
  readonly networks: { readonly [networkId: string]: NetView }
  readonly checks: readonly CheckResult[]
  readonly recording: RecordingView | null
  /** Of the first robot that has one. */
  readonly problem: Finding | null
}

/** One running lab. Every verb is synchronous; the app owns speed and frames. */
export interface Lab {
  /** Takes a document up and stands ready. @throws RangeError for a check of an unknown kind. */
  load(
    document: Document,
    floor: Floor,
    options: { readonly seed: number; readonly checks: readonly Check[] },
  ): void
  /**
   * Blocks were edited: brains follow them. While it runs, programs begin again where the robots stand; with `fromStart` a robot
   * whose own blocks were edited begins at its start pose (running.md 9).
   */
  edit(programs: Document['programs'], fromStart?: boolean): void
  /**
   * Takes another document up without beginning again: what is in both goes on from where it stands, what is new or has
   * another start pose stands there (or at the nearest free place). The way back in time ends here.
   * `stood`: where things stood when a step was done that is undone: there they stand again, their start is as before.
   */
  rebuild(document: Document, floor?: Floor, stood?: { readonly [id: string]: Pose }): void
  /**
   * Begins a run from where everything stands. After programs that have ended: from the start poses, as they began, unless a
   * hand has driven a robot since.
   */
  start(): void
  /** Ends the run, in the present. */
  stop(): void
  pause(): void
  /** Goes on; from a moment of the past as `branch` says. */
  resume(): void
  /**
   * `tick`: one tick · `block`: until the robot's next block is lit · `over`: until the next one that is not inside the block
   * of now · `network`: until the next run of a net of it
   * (running.md 10). In the past it shows what was, up to the present. `robot`: by its id, the first where none is named.
   */
  step(kind: StepKind, robot?: string): void
  /** Blocks before which a run pauses, whosever they are. They change nothing in the run itself, and outlast it. */
  setStops(blocks: readonly string[]): void
  /**
   * Lets time pass: the run, or a robot that is driven by hand while no program runs.
   * Practice that a program asks for takes no time: with `examples` about so many are practised in one call, the rest and the
   * ticks after it come with the next ones. Returns whether anything can look different now.
   */
  advance(ticks: number, examples?: number): boolean
  /** `set`: name of the weight set, '' for the knobs. */
  setWeight(brain: string, from: string, to: string, weight: number, set?: string): void
  /** Puts another brain in a network's place: reset, undo, weights of duplicated neurons. */
  setBrain(brain: string, value: Brain): void
  /**
   * Moves a robot or an obstacle by hand; an obstacle, and while no run is on a robot too, starts from there, or from
   * `start` where a move is undone. Returns where it came to stand.
   */
  place(id: string, pose: Pose, start?: Pose): Pose
  press(key: DriveKey, down: boolean, robot?: string): void
  /**
   * A hand on the pad drives a robot, after its program (running.md 16); null: it lets go. `others`: what else it holds, by
   * output neuron.
   */
  drive(wheels: Wheels | null, others?: Hand['others'], robot?: string): void
  /**
   * Writes rows into a network's table while a run is on, until it is told null or the run ends. A run goes the same with and
   * without it.
   */
  record(recording: (Omit<Recording, 'robot'> & { readonly robot: string }) | null): void
  /** Writes one row: what the network reads at this moment, and these wheels. Returns whether there was room for it. */
  remember(row: Omit<Remembered, 'robot'> & { readonly robot: string }): boolean
  /** Changes what a network was shown or how it practises; its weights stay. */
  setTraining(brain: string, change: TrainingChange): void
  /** Presses a key on a robot's own panel, or lets it go. */
  pressButton(key: RobotKey, down: boolean, robot?: string): void
  /** What a robot's program remembers at the moment that is shown. */
  variables(robot?: string): readonly Variable[]
  /** What a robot's sensors, motors, timers and keys say now; the first robot's where none is named. */
  senses(robot?: string): Senses
  /** What a robot learns by trying at the moment that is shown; null: none of its blocks does. The first robot's where none is named. */
  trying(robot?: string): TryView | null
  /**
   * Back or forth inside the run: nearest keyframe, then replay (running.md 8). The run is paused there. A tick beyond
   * the present is the present, one before the oldest moment that oldest one. What a hand changes there goes on from there.
   */
  goTo(tick: number): void
  /** Makes a moment of the past the present: its weights and obstacles too. The other future is kept, until the next (running.md 9). */
  branch(): void
  /** Changes places with the other future. Returns whether there was one: Start and edited blocks end it. */
  swap(): boolean
  /** Everything back to its start pose (running.md 10). */
  reset(): void
  /** The moment that is shown as plain data. */
  state(): Moment
  /** `robot`: whose networks; the first where none is named. */
  view(robot?: string): View
  /** What the checks that are open lack, as the run stands; first what was broken. */
  missing(): readonly Missing[]
  /** Where the lab stands, cheaper than a view. `practising`: no time passes until practice that a program asked for is done. */
  now(): { readonly tick: number; readonly phase: Phase; readonly practising: boolean }
  /** The document with the weights and start poses of the present. */
  document(): Document
  /** The floor as sensors see it at present. */
  floor(): Floor
  /** 16 hexadecimal digits over x, y, heading (float64) of all robots at every tick of this run, up to the moment that is shown. */
  hash(): string
}

export type StepKind = 'tick' | 'block' | 'over' | 'network'
