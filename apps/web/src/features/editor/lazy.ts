export { default as Editor } from './view/Editor.svelte'
export { drawBlock, drawProgram } from './view/pictures/blocks.ts'
export { explain } from './view/toolbox/explain.ts'
