import type { Feature } from '#parts/feature.ts'

export { default as TrustPage } from './TrustPage.svelte'

/** How a school's device learns to trust the server of the room, so that the lab starts there without a network. */
export const trust = {
  id: 'trust',
  words: ['trust'],
  route: 'trust',
} satisfies Feature
