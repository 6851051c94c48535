import type { Feature } from '#parts/feature.ts'

export { default as CardsPage } from './view/CardsPage.svelte'

/** Cards that somebody makes for others: the shelf where they stand, and the screen on which one is made. */
export const ownCards = {
  id: 'own-cards',
  words: ['own-cards', 'own-card'],
  route: 'cards',
  load: () => import('./lazy.ts'),
} satisfies Feature
