import type { NetTrace } from '@botgarten/learning/neural-network'
import type { Finding } from '@botgarten/blocks'
import type { Program, Project, Thread } from '@botgarten/programs'
import type { Floor, LedColour, Pose, Ray, SensorPort, SimulationState, World } from '@botgarten/simulation'

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
  | {
      readonly kind: 'weight'
      readonly brain: string
      readonly from: string
      readonly to: string
      readonly weight: number
    }
  | { readonly kind: 'key'; readonly key: DriveKey; readonly down: boolean }

export type DriveKey = 'up' | 'down' | 'left' | 'right'

/** Everything that decides how the run goes on. Plain data. */
export interface LabState {
  readonly tick: number
  readonly simulation: SimulationState
  readonly threads: readonly Thread[]
  readonly weights: {
    readonly [brain: string]: { readonly [from: string]: { readonly [to: string]: number } }
  }
  readonly keys: readonly DriveKey[]
  readonly checks: readonly unknown[]
  readonly hash: readonly [number, number]
}

export interface TrailPoint {
  readonly t: number
  readonly x: number
  readonly y: number
  readonly heading: number
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
  load(document: Document, floor: Floor, options: { seed: number; checks: readonly Check[] }): void
  /** Blocks were edited: threads begin anew where the robot stands, the timeline ends (running.md 9). */
  edit(programs: { readonly [id: string]: Program }, brains: Document['brains']): void
  start(): void
  stop(): void
  pause(): void
  resume(): void
  /** `tick`: one tick · `block`: until the next block is lit · `network`: until the next run of a net (running.md 10). */
  step(kind: 'tick' | 'block' | 'network'): void
  advance(ticks: number): void
  setWeight(brain: string, from: string, to: string, weight: number): void
  place(id: string, pose: Pose): void
  press(key: DriveKey, down: boolean): void
  /** Back or forth inside the recorded run: nearest keyframe, then replay (running.md 8). */
  goTo(tick: number): void
  /** Back to the start pose (world reset, running.md 10). */
  reset(): void
  state(): LabState
  view(): View
  document(): { world: World; brains: Document['brains'] }
  /** 16 hexadecimal digits over x, y, heading of all robots at every tick so far. */
  hash(): string
}
