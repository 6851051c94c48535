import type { Feature } from '#parts/feature.ts'

export { default as NetMenu } from './NetMenu.svelte'
export { default as NetworkPlayground } from './NetworkPlayground.svelte'

/** The Neural Network Playground. */
export const network = {
  id: 'network',
  words: ['network', 'blocks-network'],
} satisfies Feature
