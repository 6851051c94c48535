export { Code } from './code.svelte.ts'
export { default as CodeView } from './view/CodeView.svelte'
