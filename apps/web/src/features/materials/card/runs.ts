import type { LearningOutline } from '@botgarten/programs'

/** How a card of learning by trying is worked with. */
export interface Runs {
  /** Tries of each run; null: what the children choose. */
  readonly tries: readonly (number | null)[]
  /** More than three runs: their ways get lines of their own below the table. */
  readonly waysBelow: boolean
}

/** A card's runs, by its id; null for one that has a table of its own. */
export function runsOf(card: string, { pay }: Pick<LearningOutline, 'pay'>): Runs | null {
  if (pay?.own) return null
  if (card === 'mars') return { tries: [1, 10, 100], waysBelow: false }
  if (card === 'railway') return { tries: [10, 100, 1000], waysBelow: false }
  return { tries: [10, 100, 1000, null, null], waysBelow: true }
}
