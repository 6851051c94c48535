/** What a move may lead to; slippery moves have several. `reward` comes on top of what the task pays. */
export interface Outcome {
  /** 0..1; those of a move add up to 1. */
  readonly probability: number
  readonly to: number
  readonly reward?: number
}

/** A road from one station to another: an action of the station it leaves. */
export interface Move {
  readonly to: number
  /** Tells moves apart that lead to the same station: `left`. */
  readonly name?: string
  /** In the map's own unit, ≥ 0. */
  readonly length?: number
  /** Paid for every move on this road. */
  readonly reward?: number
  /** Where it really leads. Without: to `to`, for sure. */
  readonly outcomes?: readonly Outcome[]
}

/** Stations 0..n−1 and the moves that leave each: a Markov decision process with deterministic or slippery moves. */
export interface QMap {
  readonly moves: readonly (readonly Move[])[]
  /** Paid on arrival, by station. */
  readonly rewards?: { readonly [station: number]: number }
  /** Stations where an attempt ends beside the goal: holes. */
  readonly terminals?: readonly number[]
}

/** What is to be learned on a map. */
export interface Task {
  readonly map: QMap
  readonly start: number
  readonly goal: number
  /** Roads that are closed, each in one direction. */
  readonly closed?: readonly (readonly [from: number, to: number])[]
  /** For the move into the goal; without: 50. */
  readonly goalReward?: number
  /** Charged for every move. */
  readonly stepCost?: number
  /** Charged for every move, times the road's length. */
  readonly lengthCost?: number
}

/**
 * How a parameter falls: `constant`; `episodes`: times `factor` (0..1) after every episode; `visits` (α alone): times
 * 10 / (9 + n) at the n-th update of a value.
 */
export type Decay =
  | { readonly kind: 'constant' }
  | { readonly kind: 'episodes'; readonly factor: number }
  | { readonly kind: 'visits' }

/** `standard`: Sutton & Barto, 2nd edition, 6.5. `study`: Algorithm 1 of the thesis. See model.md. */
export type Rules = 'standard' | 'study'

export interface Settings {
  readonly rules: Rules
  /** `sarsa`: Sutton & Barto, 6.4. */
  readonly algorithm: 'q' | 'sarsa'
  /** Learning rate α, 0..1. */
  readonly alpha: number
  /** Discount factor γ, 0..1. */
  readonly gamma: number
  /** Probability ν to start a move somewhere else, 0..1. */
  readonly nu: number
  /** Probability ρ to explore, 0..1. */
  readonly rho: number
  readonly alphaDecay?: Decay
  readonly rhoDecay?: Decay
}

/** The learner's whole state as plain data: what it goes on from, bit for bit. */
export interface QState {
  /** By move, in the order of the map's stations and their open moves. */
  readonly q: readonly number[]
  /** How often each value was updated. */
  readonly tries: readonly number[]
  /** Where the next move starts; null: a new episode begins. */
  readonly station: number | null
  /** SARSA: index of the move that was chosen on arrival. */
  readonly chosen: number | null
  /** Whether that was by exploring. */
  readonly chosenExplores: boolean
  readonly moves: number
  readonly episodes: number
  /** Moves of the present episode. */
  readonly episodeMoves: number
  /** How often the goal was reached. */
  readonly goals: number
  /** α and ρ as they are now. */
  readonly alpha: number
  readonly rho: number
  readonly stream: readonly number[]
}

/** Why an episode ended with a move. */
export type Ending = 'goal' | 'terminal' | 'deadEnd' | 'limit'

/** One move, opened. */
export interface QTrace {
  /** Counted from 1. */
  readonly t: number
  /** Counted from 1. */
  readonly episode: number
  readonly from: number
  readonly teleported: boolean
  readonly draws: { readonly rho: number; readonly nu: number }
  /** Null: no road leaves `from`. Nothing is learned. */
  readonly decision: 'explore' | 'exploit' | null
  /** Index of the move among all; −1 without a decision. */
  readonly move: number
  /** Where it led, and where it was meant to lead. */
  readonly to: number
  readonly meant: number
  readonly reward: number
  readonly before: number
  /** max Q(s′, ·); SARSA: Q(s′, a′); 0 behind a terminal station. */
  readonly bestNext: number
  readonly after: number
  /** Learning rate of this update. */
  readonly alpha: number
  readonly ends: Ending | null
}
