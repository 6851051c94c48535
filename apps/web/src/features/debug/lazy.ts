// What a child needs who looks closely at a program that runs.
export { default as DebugPanel } from './DebugPanel.svelte'
export { Debugger } from './debugger.svelte.ts'
