import type { Feature } from '#parts/feature.ts'

/** What pupils share in their class: to look at, remix, like and race against. It comes where the device is a pupil's. */
export const gallery = {
  id: 'gallery',
  words: ['gallery', 'shared', 'network'],
  route: 'gallery',
  load: () => import('./lazy.ts'),
} satisfies Feature
