import type { Measured } from '@botgarten/experiments/cages'
import type { Pose } from '@botgarten/simulation'
import type { QuestionRun } from './questionTypes.ts'

/** What a lesson plan says besides its words: times, copies, and what Bo does as it claims. */
export interface Plan {
  /** `3` of the six lessons, or `E 7`. */
  readonly lesson: string
  /** The double lesson that it is a half of. */
  readonly double: { readonly name: string; readonly lessons: readonly [string, string] } | null
  readonly copies: readonly Copies[]
  /** In order; their words stand in a section each. */
  readonly steps: readonly PlanStep[]
  readonly claims: readonly Claim[]
}

export interface Copies {
  /** `item:<id>` or `card:<id>`. */
  readonly of: string
  /** One for the teacher, for each child, for a pair, or for so many children together. */
  readonly for: 'teacher' | 'child' | 'pair' | number
}

export interface PlanStep {
  readonly minutes: number
}

/** What the plan says of a run, which the tests make. */
export type Claim = DriveClaim | LearnClaim | PractiseClaim | RunClaim | RaceClaim | BrainsClaim | SenseClaim

/** Of those that are about learning by trying with a robot's own sensors. */
export type SenseClaim = CageClaim | TryClaim | PaidClaim

/** A card's solution with these weights on its network, or another program (`file` as in embeds), driven from a start pose. */
export interface DriveClaim {
  readonly card: string
  readonly weights?: { readonly [from: string]: { readonly [to: string]: number } }
  readonly file?: string
  /** Numbers in blocks, by the block's id. */
  readonly numbers?: { readonly [block: string]: number }
  /** Number of the start pose, from 1 as children count. */
  readonly place: number
  /** The second in which all checks have passed; null: they do not. */
  readonly passed: number | null
}

/** Of so many Bos that learn a card's way (seeds 1 to `of`): how many know a shortest way after so many tries. */
export interface LearnClaim {
  readonly learns: string
  readonly tries: number
  readonly of: number
  readonly found: number
  /** Settings that are not those of the card: `rho` and the like. */
  readonly settings?: { readonly [name: string]: number }
}

/** A card's own examples (`file` as in embeds, else the solution's), practised again from where they began. */
export interface PractiseClaim {
  readonly practises: string
  readonly file?: string
  /** Settings that are not those of the file: `rounds`, `rate`, `mirror` and the like. */
  readonly settings?: { readonly [name: string]: number | string | boolean }
  /** Hidden layers in place of those it has. */
  readonly hidden?: readonly { readonly neurons: number; readonly activation: string }[]
  /** Rows with another wish, by number from 1. */
  readonly wishes?: { readonly [row: string]: readonly number[] }
  /** Rows set aside, by number from 1; all others are practised. */
  readonly aside?: readonly number[]
  /** By round, in whole percent: how far off it is what it practises, and the test that it does not. */
  readonly off?: { readonly [round: string]: { readonly practised?: number; readonly test?: number } }
  /** Weights that it ends with, to two decimals, by the ids of both neurons. */
  readonly weights?: { readonly [from: string]: { readonly [to: string]: number } }
  /** With seeds 1, 2, …: the round in which the test is lowest. */
  readonly lowest?: readonly number[]
  /** Checks of the card that are missed from any of its places, in its order. */
  readonly misses?: readonly string[]
  /** With seeds 1 to `of`: how many pass the card from every place. */
  readonly of?: number
  readonly found?: number
}

/** What a run ends with, in the words of the questions "what will Bo do?". */
export interface RunClaim {
  readonly run: QuestionRun
  readonly answer: string
}

/** A race with the settings that it begins with: who wins, and what of the bill the plan names. */
export interface RaceClaim {
  readonly race: {
    readonly map: string
    /** `q`, `sarsa`, `best` or `random`. */
    readonly racers: readonly string[]
    readonly criterion: string
    readonly tries: number
    readonly runs: number
    readonly seed: number
  }
  readonly wins: readonly string[]
  readonly bills: { readonly [racer: string]: { readonly [column: string]: number | null } }
}

/** The ready-made brains of a course race: how far each goes in a minute, in whole cm, and its bumps from all starts. */
export interface BrainsClaim {
  readonly course: string
  readonly lanes: { readonly [kind: string]: { readonly cm: number; readonly bumps: number } }
}

/** What the measured robots of a cage of the zoo of sensors do. */
export interface CageClaim {
  readonly cage: string
  /** How many of the 20 do what it is named after. */
  readonly cheating: number
  /** Least and most of those, of each number that is named. */
  readonly those: { readonly [name in keyof Measured]?: readonly [least: number, most: number] }
  /** Of a program that honestly keeps away from things. */
  readonly honest?: { readonly [name in keyof Measured]?: number }
  /** How many do not learn to drive as is meant with the cage's mend. */
  readonly failing: number
}

/** The robot of a card's solution: after which whole minute of trying it drives as is meant, and its bumps minute by minute. */
export interface TryClaim {
  readonly trying: string
  readonly passes: number | null
  readonly bumps: readonly number[]
}

/** A robot that only drives ahead, in this world from this place: whole coins a minute, for one coin a unit of each pay. */
export interface PaidClaim {
  readonly ahead: string
  readonly from: Pose
  readonly coins: { readonly [kind in 'wheels' | 'ahead' | 'way']?: number }
}

/** Text of a plan, in the parts of its two pages. */
export interface PlanParts<Section> {
  readonly minute: Section
  readonly goals: Section
  readonly prepare: Section
  readonly network: Section
  readonly words: Section
  readonly wrong: Section
  readonly easier: Section
  readonly harder: Section
  readonly steps: readonly Section[]
  readonly check: Section
}
