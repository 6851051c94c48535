import type { Feature } from '#parts/feature.ts'

/** What a child needs who looks closely at a program that runs. */
export const debug = {
  id: 'debug',
  words: ['debug'],
  load: () => import('./lazy.ts'),
} satisfies Feature
