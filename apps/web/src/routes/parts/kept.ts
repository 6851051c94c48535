import { resolve } from '$app/paths'
import { allCards, pictureOf, placeOf } from '#lib/content/cards.ts'
import type { Kept } from '#lib/storage/projects.ts'
import * as m from '#lib/words/generated/messages.js'
import type { Level, RecentProject } from './home.ts'

const names: { readonly [card: string]: () => string } = {
  friendship: m['home.friendship'],
  fear: m['home.fear'],
  free: m['home.free'],
}

/** Where a project is opened; one under its card's own name is what the card's address opens. */
const addressOf = (card: string, id: string): string =>
  id === card
    ? resolve('/lab/[card]', { card })
    : resolve(`/lab/[card]?p=${encodeURIComponent(id)}`, { card })

/** What lies on this device, as tiles that lead back to it. */
export const recentOf = (kept: readonly Kept[]): RecentProject[] =>
  kept.map((one) => {
    const place = placeOf(one.project)
    // A project under its card's own name is called like the card, in the language of now.
    const name = (one.id === place && names[place]?.()) || one.project.name
    return { href: addressOf(place, one.id), name, when: one.changed, picture: pictureOf(place) }
  })

/** From how many of its start poses a card has been solved on this device. */
export function levelOf(card: string, kept: readonly Kept[]): Level {
  const of = allCards.find(({ id }) => id === card)?.starts.length ?? 0
  const solved = kept
    .filter(({ project }) => placeOf(project) === card)
    .flatMap(({ project }) => project.progress?.starts ?? [])
  return { passed: new Set(solved).size, of }
}
