export type * from './types.ts'
export { payKinds } from './types.ts'
export { bestAction, chooseAction, emptyTable, learn, rhoAt } from './table.ts'
export {
  bucketOf,
  bucketsOf,
  isOf,
  limits,
  payFor,
  problemOf,
  statesOf,
  stateOf,
  unitOf,
  type Facts,
  type Problem,
} from './senses.ts'
export { qSenses as learner, type SmallWorld } from './q-senses.ts'
