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

/** The same of a place: a card, the free lab or the sorting playground. */
const nameOf = (place: string): string => names[place]?.() ?? titleOf(place)
const names: { readonly [place: string]: () => string } = {
  free: m['home.free'],
  sorting: m['home.sortingTitle'],
}

/** A project that nobody has named bears its card's id, and is called like its card. */
export function shownName({
  project,
}: {
  readonly project: Pick<Project, 'name' | 'card' | 'playground'>
}): string {
  const place = placeOf(project)
  return project.name === place || project.name === 'free' ? nameOf(place) : project.name
}

interface Placed {
  readonly id: string
  readonly project: Pick<Project, 'card' | 'playground'>
}

/** Where a project is opened; one under its card's own name is what the card's address opens. */
export function addressOf({ id, project }: Placed): string {
  const card = placeOf(project)
  const which = id === card ? '' : (`?p=${encodeURIComponent(id)}` as const)
  return card === 'sorting' ? resolve(`/sorting${which}`) : resolve(`/lab/[card]${which}`, { card })
}
