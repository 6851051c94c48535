import type { Feature } from '#parts/feature.ts'

/** Learning by trying with the robot's own sensors: the table, the fan before Bo, edges, coins. */
export const senses = {
  id: 'senses',
  words: ['senses', 'blocks-q-learning', 'proof'],
  load: () => import('./lazy.ts'),
  budget: { part: 24_000 },
} satisfies Feature
