import type { Feature } from '#parts/feature.ts'

export type { Outgoing } from './outgoing.ts'

/** Writes files for Open Roberta. */
export const openRoberta = {
  id: 'open-roberta',
  words: ['open-roberta'],
  load: () => import('./lazy.ts'),
} satisfies Feature
