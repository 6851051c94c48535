export { differencesOf, type Difference } from './differences.ts'
export { fileFrom, fileInSteps, projectFrom, strangeness } from './files.ts'
export { readOpenRoberta } from './read.ts'
export { writeOpenRoberta } from './write.ts'
