import type { Feature } from '#parts/feature.ts'

export { Guide, sightOf } from './guide.svelte.ts'

/** Three moves that show what belongs together. */
export const tour = {
  id: 'tour',
  words: ['tour'],
  load: () => import('./Tour.svelte'),
} satisfies Feature
