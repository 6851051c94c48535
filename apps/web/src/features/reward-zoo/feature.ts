import type { Feature } from '#parts/feature.ts'

export { default as ZooPage } from './view/ZooPage.svelte'

/** Rewards that sound right and are not: guess what Bo does, watch it, mend the pay. */
export const rewardZoo = {
  id: 'reward-zoo',
  words: ['reward-zoo'],
  route: 'zoo',
  load: () => import('./lazy.ts'),
} satisfies Feature
