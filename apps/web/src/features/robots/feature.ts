import type { Feature } from '#parts/feature.ts'

export { Robots } from './robots.svelte.ts'

/** Several robots in one world: adding, choosing, comparing them. What one robot is made of: `features/robot`. */
export const robots = {
  id: 'robots',
  words: ['robots'],
  load: () => import('./lazy.ts'),
} satisfies Feature
