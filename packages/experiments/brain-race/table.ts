// What a page shows of a race that has been run; it does not drive itself.
export { laneKinds } from '@botgarten/programs/lanes'
export { isLess } from './measure.ts'
export { csvOf, summariesOf, type Summary } from './summary.ts'
