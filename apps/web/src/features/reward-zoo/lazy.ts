// What shows the cages, and learns in them.
export { openCage } from './model/open.ts'
export { openSenseCage } from './senses/model/open.ts'
export { default as SenseScreen } from './senses/view/SenseScreen.svelte'
export { default as CageScreen } from './view/CageScreen.svelte'
export { default as Overview } from './view/Overview.svelte'
