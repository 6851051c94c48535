export { default as ClassChip } from './view/ClassChip.svelte'
export { default as Gate } from './view/Gate.svelte'
export { default as PersonMenu } from './view/PersonMenu.svelte'
export { memberHere } from './model/member.svelte.ts'
