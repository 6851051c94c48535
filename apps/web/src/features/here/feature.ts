import type { Feature } from '#parts/feature.ts'

export { default as HerePage } from './HerePage.svelte'

/** What the machine that serves shows when it is started: how others get here, and whether a class begins. */
export const here = {
  id: 'here',
  words: ['here'],
  route: 'here',
} satisfies Feature
