import type { Feature } from '#parts/feature.ts'

export { default as MapPage } from './view/MapPage.svelte'

/** Maps of one's own: drawn, tried, and learned on. */
export const mapDesigner = {
  id: 'map-designer',
  words: ['map-designer', 'blocks-q-learning'],
  route: 'maps',
  load: () => import('./lazy.ts'),
  budget: { page: 150_000, part: 90_000 },
} satisfies Feature
