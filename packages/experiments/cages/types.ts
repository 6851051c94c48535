import type { Cheat, Measures } from '@botgarten/lab/trying'
import type { Sentence, Trial } from '@botgarten/learning/q-senses'
import type { Pose } from '@botgarten/simulation'

/** A pay that invites to cheat: `cage.json` of a folder `content/senses/<nn-id>/`. */
export interface SenseCage {
  readonly id: string
  /** Where it tries; it begins at the first of these starts and is judged from all. */
  readonly world: string
  readonly starts: readonly Pose[]
  readonly trial: Omit<Trial, 'seed'>
  readonly cheats: Cheat
  /** A pay with which it drives as is meant. */
  readonly mend: readonly Sentence[]
}

/** Numbers of a behaviour; each stands in the row of a seed. */
export type Measured = Measures & {
  /** Coins a minute, by the cage's own pay. */
  readonly pay: number
}

/** One robot that has learned in a cage. */
export interface CageRow extends Measured {
  readonly seed: number
  readonly cheats: boolean
  /** After which whole minute with the mended pay it drove without a bump from every start; null: after none. */
  readonly mended: number | null
}

/** What many robots did: `rows.json` beside the cage, made by `botgarten learn try --zoo <id> --seeds 20`. */
export interface CageRows {
  readonly minutes: number
  /** What a program gets that keeps away from things, where there is one. */
  readonly honest: Measured | null
  readonly bos: readonly CageRow[]
  /** The first robot that cheats, to be watched; where none does, the first. */
  readonly shown: {
    readonly seed: number
    readonly q: readonly number[]
    readonly tries: readonly number[]
    readonly moves: number
  }
}
