export { activations } from './types.ts'
export type * from './types.ts'
export { biasOf, biasRow, forward, layOut, trace, weightOf, type Net } from './network.ts'
export {
  copyWeights,
  emptyBrain,
  follow,
  hiddenId,
  weightsOf,
  withoutWeights,
  withWeight,
  withWeights,
} from './edit.ts'
export { pruneWeights, withActivation } from './keep.ts'
