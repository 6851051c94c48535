import type { Snippet } from 'svelte'
import type { Group, Playground } from '@botgarten/content'
import { resolve } from '$app/paths'
import { allCards, pictureOf, placeOf } from '#content/cards.ts'
import { shownName, titleOf, addressOf } from '#content/names.ts'
import type { Listed } from '#storage/projects.ts'

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

/** What lies on this device, as tiles that lead back to it. */
export const recentOf = (kept: readonly Listed[]): RecentProject[] =>
  kept.map((one) => ({
    href: addressOf(one),
    name: shownName(one),
    when: one.changed,
    picture: pictureOf(placeOf(one.project)),
  }))

/** From how many of its start poses a card has been solved on this device. */
function levelOf(card: string, kept: readonly Listed[]): Level {
  const of = allCards.find(({ id }) => id === card)?.starts ?? 0
  const solved = kept
    .filter(({ project }) => placeOf(project) === card)
    .flatMap(({ project }) => project.progress?.starts ?? [])
  return { passed: new Set(solved).size, of }
}

/** The cards of one bed, and how far each has been solved on this device. */
export const bedOf = (bed: Playground, kept: readonly Listed[]): BedCard[] =>
  allCards
    .filter((card) => card.bed === bed)
    .map(({ id, code, group }) => ({
      href: resolve('/lab/[card]', { card: id }),
      number: /\d+$/.exec(code)?.[0] ?? '',
      label: titleOf(id),
      group: group ?? null,
      level: levelOf(id, kept),
    }))
