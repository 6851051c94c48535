import type { Feature } from '#parts/feature.ts'

export type { SortingLink } from './links.ts'
export { default as Sorting } from './view/Sorting.svelte'

/** The Sorting Playground. */
export const sorting = {
  id: 'sorting',
  words: ['sorting', 'proof'],
  route: 'sorting',
  load: () => import('./lazy.ts'),
} satisfies Feature
