export { default as ClassChip } from './view/ClassChip.svelte'
export { default as Gate } from './view/Gate.svelte'
export { default as Join } from './view/Join.svelte'
export { default as PersonMenu } from './view/PersonMenu.svelte'
export { default as TogetherBar } from './view/together/TogetherBar.svelte'
export { memberHere } from './model/member.svelte.ts'
export { soon } from './model/arriving.ts'

/** What lets the class know what happens in a lab. */
export const loadFollow = () => import('./model/at-work.svelte.ts')
