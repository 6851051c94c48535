import type { Feature } from '#parts/feature.ts'

export { applyFix } from './plug.ts'

/** One robot: building it, what it senses, its panel. Several in one world: `features/robots`. */
export const robot = {
  id: 'robot',
  words: ['robot'],
  load: () => import('./lazy.ts'),
} satisfies Feature
