import type { Feature } from '#parts/feature.ts'

export type { Code } from './lazy.ts'

/** The program as Python for a real robot, beside the blocks; its highlighter (Lezer) is 21 kB of its part. */
export const python = {
  id: 'python',
  words: ['python', 'expert'],
  load: () => import('./lazy.ts'),
} satisfies Feature
