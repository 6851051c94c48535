// Blocks for deeper networks, for learning by trying and for sorting: loaded before a program that uses them is opened.
export { blocks as learning } from './blocks.ts'
export { learningToolbox } from './toolbox.ts'
