import type { Snippet } from 'svelte'
import type { Translated } from '@botgarten/content/catalogue'
import type { Chapter, Group, Playground } from '@botgarten/content'
import { resolve } from '$app/paths'
import { allCards, pictureOf, placeOf } from '#content/cards.ts'
import { shownName, titleOf, addressOf } from '#content/names.ts'
import { allowed } from '#lab/allowed.svelte.ts'
import { language } from '#words/language.svelte.ts'
import type { Listed } from '#storage/projects.ts'

/** A project that lies on this device. */
export interface RecentProject {
  readonly href: string
  readonly name: string
  /** When it was saved last, in ms since 1970. */
  readonly when: number
  /** Address of a small picture of its world, or null. */
  readonly picture: string | null
  /** Is it a card that somebody has made, ready to be played? */
  readonly isCard: boolean
}

/** Start places from which all goals were reached. */
export interface Level {
  readonly passed: number
  readonly of: number
}

/** A card of a bed. */
export interface BedCard {
  readonly href: string
  /** As printed on the card; empty in a bed whose few cards need none. */
  readonly number: string
  readonly label: string
  /** What it is about, in a sentence; empty where nothing says it. */
  readonly goal: string
  /** Address of the picture on its front, or null. */
  readonly picture: string | null
  readonly level: Level
  /** Cards of one kind bear its mark. */
  readonly group: Group | null
  /** Which part of its bed it lies in; null: the first, by hand. */
  readonly chapter?: Chapter | null
  /** A teacher has not left it open today. */
  readonly closed?: boolean
}

/** A place without goals that a bed leads to. */
export const place = (href: string, label: string, picture: string): BedCard => ({
  ...{ href, label, picture, number: '', goal: '', group: null },
  level: { passed: 0, of: 0 },
})

/** What each card is about, by its id. */
export type Goals = { readonly [card: string]: Translated<string> | undefined }

export interface HomeProps {
  /** What there is to say about this version. */
  news: Snippet
  /** What stands in the bar beside the language. */
  corner: Snippet
  /** Newest first; empty on the first visit. */
  recent: readonly RecentProject[]
  /** The cards of the beds that have some. */
  drive: readonly BedCard[]
  network: readonly BedCard[]
  learning: readonly BedCard[]
  sorting: readonly BedCard[]
  onopenfile: (file: File) => void
  /** A new project is asked for. */
  onnew: () => void
}

/** Were the goals reached from every start place? A playground without goals is never done. */
export const isDone = ({ level }: BedCard): boolean => level.of > 0 && level.passed >= level.of

/**
 * The card to play next: the first that is open and not done. One without goals is next until another has been begun.
 * Where all are done it is the first one again; null where none is open.
 */
export function nextOf(cards: readonly BedCard[]): BedCard | null {
  const begun = cards.some(({ level }) => level.passed > 0)
  const open = cards.filter(({ closed }) => !closed)
  return open.find((card) => (card.level.of > 0 ? !isDone(card) : !begun)) ?? open[0] ?? null
}

export type ShownChapter = Chapter | 'hand'

const chapterOf = ({ chapter }: BedCard): ShownChapter => chapter ?? 'hand'

/** The parts of a bed that have cards, in the order of the cards. */
export const chaptersOf = (cards: readonly BedCard[]): readonly ShownChapter[] => [
  ...new Set(cards.map(chapterOf)),
]

/** The part of a bed that is on show: the chosen one, where none was chosen that of the card to play next. */
export function chapterOnShow(cards: readonly BedCard[], chosen: ShownChapter | undefined): ShownChapter {
  if (chosen && chaptersOf(cards).includes(chosen)) return chosen
  const next = nextOf(cards)
  return next ? chapterOf(next) : 'hand'
}

export const cardsIn = (cards: readonly BedCard[], chapter: ShownChapter): readonly BedCard[] =>
  cards.filter((card) => chapterOf(card) === chapter)

/** What lies on this device, as tiles that lead back to it. */
export const recentOf = (kept: readonly Listed[]): RecentProject[] =>
  kept.map((one) => ({
    href: addressOf(one),
    name: shownName(one),
    when: one.changed,
    picture: pictureOf(placeOf(one.project)),
    isCard: one.project.ownCard !== undefined && !one.project.ownCard.draft,
  }))

/** From how many of its start poses a card has been solved on this device. */
function levelOf(card: string, kept: readonly Listed[]): Level {
  const of = allCards.find(({ id }) => id === card)?.starts ?? 0
  const solved = kept
    .filter(({ project }) => placeOf(project) === card)
    .flatMap(({ project }) => project.progress?.starts ?? [])
  return { passed: new Set(solved).size, of }
}

/** The first sentence of a text: a tile has room for one. `Intl.Segmenter` would be newer than Firefox 115. */
export const firstSentence = (text: string): string =>
  /^.*?[.!?…。！？]["'“”»«)]*(?=\s|$|(?<=[。！？]))/su.exec(text.trim())?.[0] ?? text.trim()

/** The cards of one bed, what they are about, and how far each has been solved on this device. */
export const bedOf = (bed: Playground, kept: readonly Listed[], goals: Goals): BedCard[] =>
  allCards
    .filter((card) => card.bed === bed)
    .map(({ id, code, group, chapter }) => ({
      href: resolve('/lab/[card]', { card: id }),
      number: bed === 'network' ? code.replace(/^\D+/, '') : '',
      label: titleOf(id),
      goal: firstSentence(goals[id]?.[language.locale] ?? goals[id]?.['en'] ?? ''),
      picture: pictureOf(id),
      group: group ?? null,
      chapter: chapter ?? null,
      level: levelOf(id, kept),
      closed: !allowed.isOpen(id),
    }))
