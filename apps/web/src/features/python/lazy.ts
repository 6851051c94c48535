export { Code } from './code.svelte.ts'
export { default as CodeTools } from './view/CodeTools.svelte'
export { default as CodeView } from './view/CodeView.svelte'
