// Blocks as drawings: only pages that show some wait for them.
export { drawBlock, drawProgram } from './blocks.ts'
