export { default as Elsewhere } from './Elsewhere.svelte'
export { keptHere } from './kept.ts'
