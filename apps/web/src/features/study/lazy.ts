// What a researcher and a child see of a study, and what locks and follows a lab while one is open.
export { default as Study } from './view/Study.svelte'
export { default as StudyChip } from './view/StudyChip.svelte'
export { follow } from './model/follow.ts'
export { lockLab, placeFor } from './model/locks.ts'
