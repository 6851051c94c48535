export { headOfRow, mostOf, place, shownBy } from './types.ts'
export type { Drive, Examples, Row, ShownBy } from './types.ts'
export {
  freshDrive,
  hasRoom,
  noExamples,
  shownPairs,
  withDrive,
  withRow,
  type Recorded,
  type Shown,
  type ShownPair,
} from './rows.ts'
export { columnsFor, withoutGaps } from './columns.ts'
export { withEarlierWishes } from './late.ts'
export {
  exerciseBy,
  practiceChoice,
  starterChoice,
  stepSettings,
  withChoice,
  type PracticeChoice,
} from './choice.ts'
export { afterLesson, beginLesson, errorOn, lossesOn, rightIn, type Lesson } from './lesson.ts'
export { beginExercise, beginningOfExercise, prepare, type Exercise, type Prepared } from './prepare.ts'
export { findingsIn, type ExampleFinding, type Table } from './checks/index.ts'
