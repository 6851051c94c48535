import { groupBy } from '@botgarten/browsers'
import type { CardHead } from '@botgarten/content/catalogue'

type Head = Pick<CardHead, 'id' | 'bed'>

interface FreeBed {
  readonly bed: CardHead['bed']
  readonly cards: readonly string[]
  /** How many of them are free. */
  readonly free: number
}

/**
 * The cards by their beds, in the order of the folders.
 * @param free ids of the cards that are free; null: all of them
 */
export function bedsOf(cards: readonly Head[], free: readonly string[] | null): readonly FreeBed[] {
  const beds = groupBy(cards, ({ bed }) => bed)
  return [...beds].map(([bed, of]) => {
    const ids = of.map(({ id }) => id)
    return { bed, cards: ids, free: ids.filter((id) => !free || free.includes(id)).length }
  })
}

/** With all cards chosen there is nothing to close: a card that comes with a new version is free too. */
export const freeOf = (cards: readonly Head[], chosen: ReadonlySet<string>): readonly string[] | null =>
  cards.every(({ id }) => chosen.has(id)) ? null : cards.map(({ id }) => id).filter((id) => chosen.has(id))

/** Which blocks there are. */
export const levels = ['plain', 'all'] as const
