export { default as Editor } from './Editor.svelte'
export { drawBlock, drawProgram } from './pictures/blocks.ts'
export { explain } from './shelf/explain.ts'
