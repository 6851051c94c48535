import type { Brain, NetTrace } from '@botgarten/learning/neural-network'
import type { Finding } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import type { Floor, LedColour, Pose, Ray, SensorPort } from '@botgarten/simulation'
import type { Moment } from './run.ts'

/** What a lab runs: the parts of a project that behave. */
export type Document = Pick<Project, 'programs' | 'world' | 'brains'>

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

export type Phase = 'ready' | 'running' | 'paused' | 'ended'

/** Inputs of a tick (running.md 2): together with the start state and the seed they are the whole run. */
export type Input =
  | { readonly kind: 'place'; readonly id: string; readonly pose: Pose }
  | { readonly kind: 'brain'; readonly brain: string; readonly value: Brain }
  | { readonly kind: 'key'; readonly key: DriveKey; readonly down: boolean }

export type DriveKey = 'up' | 'down' | 'left' | 'right'

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
  readonly touching: readonly string[]
  readonly rays: { readonly [port in SensorPort]?: readonly Ray[] }
  readonly trail: readonly TrailPoint[]
  readonly tones: readonly Tone[]
  readonly lit: string | null
}

/** What the screen shows, asked for once a frame. */
export interface View {
  readonly phase: Phase
  readonly tick: number
  readonly seconds: number
  readonly robots: readonly RobotView[]
  readonly obstacles: readonly { readonly id: string; readonly pose: Pose }[]
  /** By network block: the last run opened, or what a run would give now while the program stands. */
  readonly networks: { readonly [networkId: string]: NetTrace }
  readonly checks: readonly CheckResult[]
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
  /** Blocks were edited: brains follow them. While it runs, programs begin anew where the robots stand (running.md 9). */
  edit(programs: Document['programs']): void
  start(): void
  stop(): void
  pause(): void
  resume(): void
  /** `tick`: one tick · `block`: until the next block is lit · `network`: until the next run of a net (running.md 10). */
  step(kind: StepKind): void
  /**
   * Lets time pass: the run, or a robot that is driven by hand while no program runs.
   * Returns whether anything can look different now.
   */
  advance(ticks: number): boolean
  setWeight(brain: string, from: string, to: string, weight: number): void
  /** Puts another brain in a network's place: reset, undo, weights of duplicated neurons. */
  setBrain(brain: string, value: Brain): void
  /** Moves a robot or an obstacle by hand; while no run is on, that is where it starts from. Returns where it came to stand. */
  place(id: string, pose: Pose): Pose
  press(key: DriveKey, down: boolean): void
  /** Back or forth inside the run: nearest keyframe, then replay (running.md 8). The run is paused there. */
  goTo(tick: number): void
  /** Everything back to its start pose (running.md 10). */
  reset(): void
  /** The present moment as plain data. */
  state(): Moment
  view(): View
  /** The document with the weights and start poses of now. */
  document(): Document
  /** 16 hexadecimal digits over x, y, heading (float64) of all robots at every tick of this run. */
  hash(): string
}

export type StepKind = 'tick' | 'block' | 'network'
