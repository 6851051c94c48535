import type { Feature } from '#parts/feature.ts'

/** A network learns from examples: it is shown some, and practises them. */
export const training = {
  id: 'training',
  words: ['training', 'network', 'proof'],
  load: () => import('./lazy.ts'),
} satisfies Feature
