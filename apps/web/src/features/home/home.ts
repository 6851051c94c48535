import type { Snippet } from 'svelte'
import type { Group } from '@botgarten/content'

/** A project that lies on this device. */
export interface RecentProject {
  readonly href: string
  readonly name: string
  /** When it was saved last, in ms since 1970. */
  readonly when: number
  /** Address of a small picture of its world, or null. */
  readonly picture: string | null
}

/** Start places from which all goals were reached. */
export interface Level {
  readonly passed: number
  readonly of: number
}

/** A card of a bed. */
export interface BedCard {
  readonly href: string
  /** As printed on the card. */
  readonly number: string
  readonly label: string
  readonly level: Level
  /** Cards that lie together under a word of their own. */
  readonly group: Group | null
}

export interface HomeProps {
  /** What there is to say about this version. */
  news: Snippet
  /** Newest first; empty on the first visit. */
  recent: readonly RecentProject[]
  /** The cards of the beds that have some. */
  drive: readonly BedCard[]
  network: readonly BedCard[]
  learning: readonly BedCard[]
  sorting: readonly BedCard[]
  onopenfile: (file: File) => void
}

/** Cards in a row that lie together, in their order. */
export function runsOf(cards: readonly BedCard[]): { group: Group | null; cards: BedCard[] }[] {
  const runs: { group: Group | null; cards: BedCard[] }[] = []
  for (const card of cards) {
    const last = runs.at(-1)
    if (last?.group === card.group) last.cards.push(card)
    else runs.push({ group: card.group, cards: [card] })
  }
  return runs
}
