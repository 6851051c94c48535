export * from './types.ts'
export { paidAt, settingsOf, untouched, worldOf } from './task.ts'
export { bestMoves, circleOf, isMended, outcomeOf, provedOf, walkOf, type Moves } from './behaviour.ts'
export { learnIn, type Learned } from './learned.ts'
