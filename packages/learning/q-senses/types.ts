/** How it learns. */
export interface Settings {
  /** Learning rate α, 0..1. */
  readonly alpha: number
  /** Discount factor γ, 0..1. */
  readonly gamma: number
  /** Probability ε to explore at the first move, 0..1; files and options call it ρ. */
  readonly rho: number
  /** Over so many moves ρ falls in a straight line to 0.3 of itself; there it stays. A whole number, ≥ 1. */
  readonly fall: number
  /** `visits`: α · 10 / (9 + n) at the n-th update of a value. */
  readonly alphaDecay?: 'constant' | 'visits'
}

/** Values and counts of a learner, as plain data: by state, then action. */
export interface QTable {
  readonly q: number[]
  /** How often each value was updated. */
  readonly tries: number[]
  /** How many updates there were. */
  moves: number
}

/** What a sensor port is asked for. */
export interface Sensor {
  readonly port: '1' | '2' | '3' | '4'
  readonly mode: 'distance' | 'light' | 'colour' | 'touch'
}

/** Both wheels in percent, −100..100, and what the lamp does meanwhile; without it the lamp is left as it is. */
export interface Action {
  readonly left: number
  readonly right: number
  readonly lamp?: 'green' | 'orange' | 'red' | 'off'
}

/** A place where a try may begin, cm. */
export interface Place {
  readonly x: number
  readonly y: number
}

/** What is paid for; see `facts.ts` and model.md. */
export const payKinds = [
  ...(['bump', 'moment', 'ahead', 'way', 'wheels', 'farther'] as const),
  ...(['open', 'near', 'tile', 'black', 'line', 'free'] as const),
] as const
export type PayKind = (typeof payKinds)[number]

/** A sentence of pay: `coins`, −20..20, for each unit of what it pays for. */
export interface Sentence {
  readonly for: PayKind
  readonly coins: number
}

/** Everything that decides what a robot learns in its world, beside that world. */
export interface Trial {
  /** At most 3. */
  readonly sensors: readonly Sensor[]
  /** Of each sensor, rising: a reading in bucket k has reached k of them. */
  readonly edges: readonly (readonly number[])[]
  /** While the body touches something that is one state of its own, the last one. */
  readonly bump: boolean
  readonly actions: readonly Action[]
  /** Ticks of 1/60 s for which an action is held, 6..60. */
  readonly hold: number
  readonly pay: readonly Sentence[]
  /** Does a bump end a try? Its value then ends too; that of a try whose time is over goes on. */
  readonly bumpEnds: boolean
  readonly alpha: number
  readonly gamma: number
  readonly rho: number
  readonly seed: number
  /** Each try begins at one of these by chance, at most 8; not there: where the robot stands at the start. */
  readonly starts?: readonly Place[]
}

/** Pay and bumps of one simulated minute. A bump that lasts is one. */
export interface Minute {
  readonly pay: number
  readonly bumps: number
}

/** A learned table as a project holds it: from its seed it is learned again, the same every time. */
export interface TableBrain extends Trial, Readonly<QTable> {
  readonly kind: 'table'
  /** Whole minutes in which it was learned, to be shown; there where a lab has learned it. */
  readonly curve?: readonly Minute[]
}

/** One move with all its numbers. */
export interface TryTrace {
  /** Counted from 1. */
  readonly t: number
  readonly from: number
  readonly action: number
  readonly decision: 'explore' | 'exploit'
  readonly to: number
  readonly reward: number
  readonly before: number
  /** max Q(s′, ·); 0 behind a bump that ends the try. */
  readonly bestNext: number
  readonly after: number
  /** Learning rate of this update. */
  readonly alpha: number
  readonly ends: boolean
}
