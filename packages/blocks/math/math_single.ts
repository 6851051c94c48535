import { exp, ln, log10, pow } from '@botgarten/numbers'
import { numberFunction } from '../parts/number-functions.ts'

export const math_single = numberFunction('math_single', 'expert', [
  ['ROOT', 'root', Math.sqrt],
  ['ABS', 'absolute', Math.abs],
  ['NEG', 'negative', (x) => 0 - x],
  ['LN', 'ln', ln],
  ['LOG10', 'log10', log10],
  ['EXP', 'exp', exp],
  ['POW10', 'pow10', (x) => pow(10, x)],
  ['SQUARE', 'square', (x) => x * x],
])
