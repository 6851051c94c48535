export { expert } from './expert.ts'
export { callBlock, expertToolbox, variableBlocks } from './toolbox-expert.ts'
