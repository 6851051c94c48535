import { resolve } from '$app/paths'
import { allCards, pictureOf, placeOf } from '#content/cards.ts'
import { shownName, titleOf } from '#content/names.ts'
import { addressOf } from '#content/places.ts'
import type { Listed } from '#storage/projects.ts'
import type { Playground } from '@botgarten/content'
import type { BedCard, Level, RecentProject } from './home.ts'

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
