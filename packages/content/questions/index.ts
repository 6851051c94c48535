export type * from '../schema/questionTypes.ts'
export { readQuestion, readQuestionText } from '../schema/question.ts'
