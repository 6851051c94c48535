import type { Feature } from '#parts/feature.ts'

export { damagedName } from './names.ts'
export type { Action } from './projects.ts'
export { default as BinnedProject } from './BinnedProject.svelte'
export { default as KeptNotice } from './KeptNotice.svelte'
export { default as NewProject } from './NewProject.svelte'
export { default as Outcome } from './Outcome.svelte'
export { default as ProjectGrid } from './ProjectGrid.svelte'
export { default as RenameDialog } from './RenameDialog.svelte'
export { ProjectList } from './project-list.svelte.ts'

/** The projects of this device. */
export const projects = {
  id: 'projects',
  words: ['projects', 'files', 'open-roberta', 'share'],
  route: 'projects',
} satisfies Feature
