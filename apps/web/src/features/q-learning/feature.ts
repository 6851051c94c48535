import type { Feature } from '#parts/feature.ts'

export type { Learner } from './lazy.ts'

/** The Q-learning Playground: it comes when a program first learns by trying. */
export const qLearning = {
  id: 'q-learning',
  words: ['q-learning', 'blocks-q-learning', 'proof'],
  load: () => import('./lazy.ts'),
} satisfies Feature
