import type { Feature } from '#parts/feature.ts'

export { hasClasses } from './model/state.ts'

export type { Together } from './model/together/together.svelte.ts'

/** A pupil in a class: its door, where its work is. It comes where the device is a pupil's. */
export const schoolClass = {
  id: 'class',
  words: ['class'],
  route: 'join',
  load: () => import('./lazy.ts'),
} satisfies Feature
