export type * from './types.ts'
export { readQuestion, readQuestionText } from './question.ts'
export { outcomeOf } from './answer.ts'
