import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Drive } from '@botgarten/learning/neural-network/examples'
import type { Percent, Pose, RobotKey } from '@botgarten/simulation'

/** Inputs of a tick (running.md 2): together with the start state and the seed they are the whole run. */
export type Input =
  | { readonly kind: 'place'; readonly id: string; readonly pose: Pose }
  | { readonly kind: 'brain'; readonly brain: string; readonly value: Brain }
  | ({ readonly kind: 'weight' } & WeightChange)
  /** `robot`: index of the one that the hand at the keys drives. */
  | { readonly kind: 'key'; readonly key: DriveKey; readonly down: boolean; readonly robot: number }
  /** A hand on the pad, in whole percent; `left` and `right` null: it lets go. */
  | ({ readonly kind: 'drive' } & (Hand | LetGo))
  /** From here on rows are written, or no more (null). It changes nothing in how the run goes on. */
  | { readonly kind: 'record'; readonly recording: Recording | null }
  /** One row is written: what the network reads at this moment, and what was wished. */
  | ({ readonly kind: 'remember' } & Remembered)
  /** What a network was shown, or how it practises, was changed by hand. */
  | ({ readonly kind: 'training'; readonly brain: string } & TrainingChange)
  /** A key on a robot's own panel. */
  | { readonly kind: 'button'; readonly key: RobotKey; readonly down: boolean; readonly robot: number }

/** `set`: name of the weight set, '' for the weights on the knobs. */
export interface WeightChange {
  readonly brain: string
  readonly from: string
  readonly to: string
  readonly weight: number
  readonly set: string
}

/** Speeds of both wheels. */
export interface Wheels {
  readonly left: Percent
  readonly right: Percent
}

/** A hand on the pad. */
export interface Hand extends Wheels {
  /** Index of the robot. */
  readonly robot: number
  /** What else it holds, in percent by output neuron: lamps and words 100 or −100. */
  readonly others: { readonly [neuronId: string]: number }
}

interface LetGo {
  readonly robot: number
  readonly left: null
  readonly right: null
}

/** Rows that are written while time passes (running.md 14 to 17). By 'program': what the program does, else what a hand holds. */
export interface Recording {
  /** Index of the robot. */
  readonly robot: number
  /** Id of its network block, whether that runs or not. */
  readonly network: string
  readonly drive: Drive
  /** A row in ticks that are divisible by it: 1 to 60. */
  readonly every: number
}

export interface Remembered {
  readonly robot: number
  readonly network: string
  readonly drive: Drive
  readonly wheels: Wheels
  readonly others: Hand['others']
}

/** Null: there are none any more. */
export interface TrainingChange {
  readonly examples?: Brain['examples'] | null
  readonly practice?: Brain['practice'] | null
}

export type DriveKey = 'up' | 'down' | 'left' | 'right'
