import { numberFunction } from '../parts/number-functions.ts'

/** Half is rounded up. */
export const math_round = numberFunction('math_round', 'expert', [
  ['ROUND', 'round', Math.round],
  ['ROUNDUP', 'roundUp', Math.ceil],
  ['ROUNDDOWN', 'roundDown', Math.floor],
])
