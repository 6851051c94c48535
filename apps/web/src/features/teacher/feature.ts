import type { Feature } from '#parts/feature.ts'

export { default as TeacherPage } from './view/TeacherPage.svelte'
export { default as TakeClass } from './view/account/TakeClass.svelte'
export { default as FirstStart } from './view/start/FirstStart.svelte'
export { default as AccountPage } from './view/account/AccountPage.svelte'
export { default as HealthPage } from './view/health/HealthPage.svelte'
export { default as Projector } from './view/projector/Projector.svelte'
export { isView, toClass, type View } from './view/ways.ts'

/** The teacher's pages: accounts, classes, who is doing what, what is kept. */
export const teacher = {
  id: 'teacher',
  words: ['teacher', 'doctor', 'shared'],
  route: 'teacher',
  load: () => import('./lazy.ts'),
  budget: 110_000,
} satisfies Feature
