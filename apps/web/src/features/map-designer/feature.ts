import type { Feature } from '#parts/feature.ts'

export { default as MapPage } from './view/MapPage.svelte'

/** Maps of one's own: drawn, tried, and learned on. */
export const mapDesigner = {
  id: 'map-designer',
  words: ['map-designer', 'blocks-q-learning'],
  route: 'maps',
  load: () => import('./lazy.ts'),
} satisfies Feature
