export { outcomeOf, type Asked, type Given } from './questions/outcome.ts'
export { rideOf, type Ride } from './questions/ride.ts'
