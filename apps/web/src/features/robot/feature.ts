import type { Feature } from '#parts/feature.ts'

export { addNeuron, applyFix } from './plug.ts'

/** Bo's own parts: building it, what it senses, its panel. */
export const robot = {
  id: 'robot',
  words: ['robot'],
  load: () => import('./lazy.ts'),
  budget: { part: 14_000 },
} satisfies Feature
