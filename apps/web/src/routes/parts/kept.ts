import { resolve } from '$app/paths'
import { allCards, pictureOf, placeOf } from '#lib/content/cards.ts'
import type { Kept } from '#lib/storage/database.ts'
import * as m from '#lib/words/generated/messages.js'
import type { BedCard, Level, RecentProject } from './home.ts'

type Named = (facts?: object, options?: { locale: 'en' }) => string

const names: { readonly [card: string]: Named } = {
  forward: m['home.forward'],
  square: m['home.square'],
  stop: m['home.stop'],
  chameleon: m['home.chameleon'],
  friendship: m['home.friendship'],
  fear: m['home.fear'],
  free: m['home.free'],
}

/** The name of the card a project belongs to, in the language of now; null in the free lab. */
export function cardName({ project }: Pick<Kept, 'project'>): string | null {
  const place = placeOf(project)
  return place === 'free' ? null : (names[place]?.() ?? place)
}

/** Where a project is opened; one under its card's own name is what the card's address opens. */
export function addressOf({ id, project }: Pick<Kept, 'id' | 'project'>): string {
  const card = placeOf(project)
  return id === card
    ? resolve('/lab/[card]', { card })
    : resolve(`/lab/[card]?p=${encodeURIComponent(id)}`, { card })
}

/** A project that nobody has named is called like its card, in the language of now. */
export function shownName({ id, project }: Pick<Kept, 'id' | 'project'>): string {
  const place = placeOf(project)
  const own = names[place]
  const unnamed = project.name === 'free' || (id === place && project.name === own?.({}, { locale: 'en' }))
  return unnamed && own ? own() : project.name
}

/** What lies on this device, as tiles that lead back to it. */
export const recentOf = (kept: readonly Kept[]): RecentProject[] =>
  kept.map((one) => ({
    href: addressOf(one),
    name: shownName(one),
    when: one.changed,
    picture: pictureOf(placeOf(one.project)),
  }))

/** From how many of its start poses a card has been solved on this device. */
function levelOf(card: string, kept: readonly Kept[]): Level {
  const of = allCards.find(({ id }) => id === card)?.starts.length ?? 0
  const solved = kept
    .filter(({ project }) => placeOf(project) === card)
    .flatMap(({ project }) => project.progress?.starts ?? [])
  return { passed: new Set(solved).size, of }
}

/** The cards of one playground, and how far each has been solved on this device. */
export const bedOf = (playground: 'drive' | 'network', kept: readonly Kept[]): BedCard[] =>
  allCards
    .filter((card) => card.playground === playground)
    .map(({ id }) => ({
      href: resolve('/lab/[card]', { card: id }),
      label: names[id]?.() ?? id,
      level: levelOf(id, kept),
    }))
