import type { Feature } from '#parts/feature.ts'

/** Learning by trying with the robot's own sensors: the table, the fan before Bo, edges, coins, nights. */
export const senses = {
  id: 'senses',
  words: ['senses', 'night', 'blocks-q-learning', 'proof'],
  load: () => import('./lazy.ts'),
} satisfies Feature
