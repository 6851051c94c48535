import type { Settings } from '@botgarten/learning/q-learning'

/** A small mission whose reward sounds right and is not: `cage.json` of a folder `content/zoo/<nn-id>/`. */
export interface Cage {
  readonly id: string
  readonly start: number
  readonly goal: number
  /** What the mission means, beside coming to the goal. */
  readonly wish: Wish
  readonly pay: readonly Pay[]
  /** An attempt goes on at the goal. */
  readonly endless?: true
  readonly mend: Mend
  /** The setting of `mend` at which the wish comes true. */
  readonly solution: number
  /** What the best behaviour comes to at both offered discount factors, before anything is mended. */
  readonly claim: { readonly [gamma in Offered]: Outcome }
  /** Stations between which it then goes on for ever, at the large discount factor. */
  readonly circle?: readonly number[]
  /** Where it decides against the mission, and where the mission leads from there. */
  readonly why?: { readonly at: number; readonly to: number }
  /** How Bo learns here. */
  readonly setting: Pick<Settings, 'alpha' | 'gamma' | 'nu' | 'rho'> & { readonly episodes: number }
  /** Where this happened in the world. */
  readonly source: Source
}

export interface Wish {
  /** Stations on every way that is meant. */
  readonly passes?: readonly number[]
  /** Moves at most. */
  readonly moves?: number
}

export interface Source {
  readonly by: string
  readonly year: number
  readonly title: string
  /** Where it was published. */
  readonly in: string
  readonly address?: string
}

/** What a rule pays; costs are negative. */
export type Pay =
  /** For the move into the goal. */
  | { readonly for: 'goal'; readonly reward: number }
  /** Each time on arrival. */
  | { readonly for: 'station'; readonly station: number; readonly reward: number }
  | { readonly for: 'move'; readonly reward: number }
  /** Each time this road is taken: in this direction, or in both. */
  | {
      readonly for: 'road'
      readonly from: number
      readonly to: number
      readonly both?: true
      readonly reward: number
    }
  /** For a move after which `from` is more moves away than before. */
  | { readonly for: 'away'; readonly from: number; readonly reward: number }
  /**
   * For each move that the goal is nearer than before. `back`: what a move away from it gives back: `nothing`; `same`: as
   * much as was paid; `exact`: γΦ(s′) − Φ(s) with Φ = −reward · distance, which changes no best behaviour (Ng, Harada, Russell 1999).
   */
  | { readonly for: 'nearer'; readonly reward: number; readonly back: 'nothing' | 'same' | 'exact' }

/** The change that a child may make: another reward of a rule, or another set of rules. */
export type Mend =
  | {
      readonly rule: number
      readonly least: number
      readonly most: number
      readonly step: number
      /** What is set is taken away. */
      readonly costs?: true
    }
  | { readonly options: readonly MendOption[] }

export interface MendOption {
  readonly id: string
  readonly pay: readonly Pay[]
  readonly endless?: true
}

/** The two discount factors that the blocks offer. */
export const offered = { aLot: 0.8, aLittle: 0.2 } as const
export type Offered = keyof typeof offered

/** `wish`: it comes to the goal as it is meant · `other`: it comes there otherwise · `never`: it does not come there. */
export type Outcome = 'wish' | 'other' | 'never'
