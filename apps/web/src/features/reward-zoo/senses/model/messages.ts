import type { Mended, SenseCage, watchedIn } from '@botgarten/experiments/cages'
import type { Sentence, TableBrain } from '@botgarten/learning/q-senses'
import type { Picture, World } from '@botgarten/simulation'

/** A world with the robot on each of a cage's starts; its floor's picture, where a sensor looks at it. */
export interface Grounds {
  readonly worlds: readonly World[]
  readonly picture: Picture | null
}

/** What the page asks of the worker: to know a cage, then to drive there by a table, or to learn with a pay. */
export type Order =
  | { readonly kind: 'open'; readonly cage: SenseCage; readonly grounds: Grounds }
  | { readonly kind: 'watch'; readonly table: TableBrain }
  | { readonly kind: 'learn'; readonly pay: readonly Sentence[]; readonly seed: number }

/** What was driven, and how it was learned. */
export type Seen = ReturnType<typeof watchedIn> & Mended

export type Report =
  { readonly kind: 'minute'; readonly minute: number } | { readonly kind: 'seen'; readonly seen: Seen }
