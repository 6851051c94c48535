import type { Feature } from '#parts/feature.ts'

export { default as RacePage } from './view/RacePage.svelte'

/** Races of learners on one map, of brains on one floor, and a child who walks against Bo. */
export const races = {
  id: 'races',
  words: ['races', 'blocks-q-learning', 'worlds'],
  route: 'race',
  load: () => import('./lazy.ts'),
} satisfies Feature
