import type { Feature } from '#parts/feature.ts'

export { Crew } from './robots.svelte.ts'

/** More robots than one in a world: they come when another one is wanted. */
export const crew = {
  id: 'crew',
  words: ['crew'],
  load: () => import('./lazy.ts'),
  budget: { part: 5_000 },
} satisfies Feature
