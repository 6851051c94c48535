import type { Feature } from '#parts/feature.ts'

/** What is seen inside a network: why, its function, its field. */
export const inside = {
  id: 'inside',
  words: ['inside', 'network'],
  load: () => import('./lazy.ts'),
} satisfies Feature
