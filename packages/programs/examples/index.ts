export { ExamplesError, type ExamplesProblem } from './error.ts'
export {
  examplesFile,
  fitExamples,
  joinExamples,
  parseExamplesFile,
  roomBehind,
  type ExamplesFile,
} from './file.ts'
export { hiddenActivations, withHidden, type Hidden } from './hidden.ts'
export { choiceIn, mirrorIn, wheelsIn } from './sides.ts'
export { examplesCsv, examplesFromTable } from './table.ts'
