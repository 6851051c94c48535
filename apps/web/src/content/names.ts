import type { Project } from '@botgarten/programs'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'
import { allCards, placeOf } from './cards.ts'
import { resolve } from '$app/paths'

/** What a card is called, in the language of now; its id where there is no such card. */
export function titleOf(id: string): string {
  const title = allCards.find((card) => card.id === id)?.title
  return title?.[language.locale] ?? title?.['en'] ?? id
}

/** The same of a place: a card or the free lab. */
const nameOf = (place: string): string => (place === 'free' ? m['home.free']() : titleOf(place))

/** A project that nobody has named bears its card's id, and is called like its card. */
export function shownName({ project }: { readonly project: Pick<Project, 'name' | 'card'> }): string {
  const place = placeOf(project)
  return project.name === place || project.name === 'free' ? nameOf(place) : project.name
}

/** The same for a project of which nothing else can be read; null where even that is missing. */
export function damagedName(name: string | null, raw: unknown): string | null {
  if (name === null) return null
  const card = (raw as { readonly card?: unknown } | null)?.card
  return shownName({ project: { name, card: String(card) } })
}

interface Placed {
  readonly id: string
  readonly project: Pick<Project, 'card'>
}

/** The name of the card a project belongs to, in the language of now; null in the free lab. */
export function cardName({ project }: Pick<Placed, 'project'>): string | null {
  const place = placeOf(project)
  return place === 'free' ? null : titleOf(place)
}

/** Where a project is opened; one under its card's own name is what the card's address opens. */
export function addressOf({ id, project }: Placed): string {
  const card = placeOf(project)
  return id === card
    ? resolve('/lab/[card]', { card })
    : resolve(`/lab/[card]?p=${encodeURIComponent(id)}`, { card })
}
