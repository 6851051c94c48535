import type { Feature } from '#parts/feature.ts'

export { default as BuildButton } from './BuildButton.svelte'
export { BuildMode } from './build-mode.svelte.ts'
export { default as WorldPane } from './WorldPane.svelte'

/** The world that Bo drives in; building it and its time machine come by a click. */
export const world = {
  id: 'world',
  words: ['time', 'world-building', 'worlds', 'files'],
  load: () => import('./lazy.ts'),
} satisfies Feature
