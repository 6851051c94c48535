export { readOpenRoberta } from './read.ts'
export { writeOpenRoberta } from './write.ts'
