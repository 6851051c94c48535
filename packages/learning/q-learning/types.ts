/** What an action may lead to; slippery ones have several. `reward` comes on top of what the task pays. */
export interface Outcome {
  /** 0..1; those of an action add up to 1. */
  readonly probability: number
  readonly to: number
  readonly reward?: number
  /** It is a fall, off a cliff: counted, and nothing else. */
  readonly falls?: boolean
}

/** An action of the state it leaves: on a map, a road to another station. */
export interface Action {
  readonly to: number
  /** Tells actions apart that lead to the same state: `left`. */
  readonly name?: string
  /** In the map's own unit, ≥ 0. */
  readonly length?: number
  /** Paid each time it is taken. */
  readonly reward?: number
  /** Where it really leads. Without: to `to`, for sure. */
  readonly outcomes?: readonly Outcome[]
  /** Probability 0..1 to slide onto one of the other open actions of the state, all alike. Without: 0. */
  readonly slip?: number
}

/** States 0..n−1 (stations of a map) and the actions of each: a Markov decision process, deterministic or slippery. */
export interface QMap {
  readonly actions: readonly (readonly Action[])[]
  /** Paid on arrival, by state. */
  readonly rewards?: { readonly [state: number]: number }
  /** States where an attempt ends beside the goal: holes. */
  readonly terminals?: readonly number[]
  /** States that count as the goal beside the goal of the task: each pays what the goal pays, and ends an attempt. */
  readonly goals?: readonly number[]
  /** Goals pay but end nothing: an attempt goes on until its limit. */
  readonly endless?: boolean
}

/** What is to be learned on a map. */
export interface Task {
  readonly map: QMap
  readonly start: number
  readonly goal: number
  /** Roads that are closed, each in one direction. */
  readonly closed?: readonly (readonly [from: number, to: number])[]
  /** For the step into the goal; without: 50. */
  readonly goalReward?: number
  /** Charged for every step. */
  readonly stepCost?: number
  /** Charged for every step, times the length of its action. */
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
  /** Probability ν to start a step somewhere else, 0..1. */
  readonly nu: number
  /** Probability ε to explore, 0..1; files and options call it ρ, as the thesis does. */
  readonly rho: number
  readonly alphaDecay?: Decay
  readonly rhoDecay?: Decay
}

/** The learner's whole state as plain data: what it goes on from, bit for bit. */
export interface QState {
  /** By action, in the order of the states and their open actions. */
  readonly q: readonly number[]
  /** How often each value was updated. */
  readonly tries: readonly number[]
  /** Where the next step starts; null: a new episode begins. */
  readonly state: number | null
  /** SARSA: index of the action that was chosen on arrival. */
  readonly chosen: number | null
  /** Whether that was by exploring. */
  readonly chosenExplores: boolean
  readonly steps: number
  readonly episodes: number
  /** Steps of the present episode. */
  readonly episodeSteps: number
  /** How often the goal was reached. */
  readonly goals: number
  /** α and ε as they are now. */
  readonly alpha: number
  readonly epsilon: number
  readonly stream: readonly number[]
}

/** Why an episode ended with a step. */
export type Ending = 'goal' | 'terminal' | 'deadEnd' | 'limit'

/** One step with all its numbers. */
export interface QTrace {
  /** Counted from 1. */
  readonly t: number
  /** Counted from 1. */
  readonly episode: number
  readonly from: number
  readonly teleported: boolean
  readonly draws: { readonly epsilon: number; readonly nu: number }
  /** Null: no action leaves `from`. Nothing is learned. */
  readonly decision: 'explore' | 'exploit' | null
  /** Index of the action among all; −1 without a decision. */
  readonly action: number
  /** Where it led, and where it was meant to lead. */
  readonly to: number
  readonly meant: number
  readonly reward: number
  readonly before: number
  /** max Q(s′, ·); SARSA: Q(s′, a′); 0 behind a terminal state. */
  readonly bestNext: number
  readonly after: number
  /** Learning rate of this update. */
  readonly alpha: number
  readonly ends: Ending | null
}
