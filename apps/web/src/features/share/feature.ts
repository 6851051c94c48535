import type { Feature } from '#parts/feature.ts'

/** A project as a link. */
export const share = {
  id: 'share',
  words: ['share'],
  load: () => import('./ShareDialog.svelte'),
} satisfies Feature
