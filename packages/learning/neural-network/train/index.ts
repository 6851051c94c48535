export type {
  Ending,
  Practice,
  PracticeData,
  Rows,
  SavedPractice,
  Settings,
  TrainNet,
  TrainTrace,
} from './types.ts'
export { beginningOf, type Beginning } from './beginning.ts'
export { meanLoss, percentOff, rightRows, type Measured } from './errors.ts'
export { layOutTraining, parametersIn, weightsIn } from './layout.ts'
export { obstacleTo, type Obstacle } from './obstacles.ts'
export {
  beginCurve,
  byHeartSince,
  pointOf,
  practise,
  practiseFor,
  sleepingIn,
  type CurvePoint,
} from './practise.ts'
export { rowsOf, type Mirror, type Pair } from './rows.ts'
export { starter } from './settings.ts'
export { beginPractice } from './state.ts'
export { stepSome } from './step.ts'
