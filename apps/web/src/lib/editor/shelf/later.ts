// Looking for a block by its words: brought when a child wants to.
export { default as Search } from './Search.svelte'
