import type { Feature } from '#parts/feature.ts'

export { default as QuestionnairePage } from './view/QuestionnairePage.svelte'
export { default as ClassQuestionPage } from './view/ClassQuestionPage.svelte'
export { isView, type View } from './view/views.ts'

/** Questionnaires: asked on this device or on paper, and what was answered beside the study of 2020. */
export const questionnaires = {
  id: 'questionnaires',
  words: ['questionnaires'],
  route: 'questionnaires',
  load: () => import('./lazy.ts'),
} satisfies Feature
