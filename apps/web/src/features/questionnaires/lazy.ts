// What asks, counts and shows; a page has one of them.
export { default as Asking } from './view/asking/Asking.svelte'
export { default as ChangeForm } from './view/teacher/ChangeForm.svelte'
export { default as Overview } from './view/teacher/Overview.svelte'
export { default as PaperForm } from './view/paper/PaperForm.svelte'
export { default as Results } from './view/results/Results.svelte'
export { default as TypeIn } from './view/teacher/TypeIn.svelte'
export { Sheets } from './model/sheets.svelte.ts'
