export { beginNight, rideBy, type Night, type Ride } from './overnight.ts'
export { tableOf, type Minute, type TryState } from './try.ts'
export type { TryView } from './shown.ts'
export { isLearned, ticksOf } from './trials.ts'
