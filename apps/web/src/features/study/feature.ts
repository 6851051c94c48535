import type { Feature } from '#parts/feature.ts'

export { default as StudyPage } from './view/StudyPage.svelte'

/** Study mode: what a researcher locks, and what is written down of children who agree. Nothing of it comes without a study. */
export const study = {
  id: 'study',
  words: ['study', 'blocks-q-learning'],
  route: 'study',
  load: () => import('./lazy.ts'),
} satisfies Feature
