import { allCards, placeOf } from '#content/cards.ts'
import type { IconName } from '#parts/icons.ts'
import type { Listed } from '#storage/projects.ts'

/** The kind of a project as its tile names it: its playground, the bed of its card, an own card, or the free lab. */
export type Kind = 'network' | 'trying' | 'sorting' | 'drive' | 'card' | 'free'

/** The icon of each kind, and the custom property of its colour. */
export const kinds: { readonly [kind in Kind]: { readonly icon: IconName; readonly colour: string } } = {
  network: { icon: 'network', colour: '--network' },
  trying: { icon: 'route', colour: '--learning' },
  sorting: { icon: 'shapes', colour: '--sorting' },
  drive: { icon: 'play', colour: '--start' },
  card: { icon: 'card', colour: '--block-control' },
  free: { icon: 'wrench', colour: '--block-control' },
}

const ofBeds = { network: 'network', 'q-learning': 'trying', sorting: 'sorting', drive: 'drive' } as const

export function kindOf({ project }: Pick<Listed, 'project'>): Kind {
  if (project.ownCard) return 'card'
  const place = placeOf(project)
  if (place === 'sorting') return place
  const card = allCards.find(({ id }) => id === place)
  if (!card) return 'free'
  return card.chapter === 'trying' ? 'trying' : ofBeds[card.bed]
}
