// Looking for a block by its words, and what one does: brought when a child wants to.
export { explain } from './explain.ts'
export { default as Search } from './Search.svelte'
