export type * from './types.ts'
export { forward, layOut, trace, weightOf, type Net } from './network.ts'
export {
  copyWeights,
  emptyBrain,
  follow,
  pruneWeights,
  weightsOf,
  withoutWeights,
  withWeight,
  withWeights,
} from './edit.ts'
