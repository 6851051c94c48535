import { whole } from '../python.ts'
import { acos, asin, atan, cos, sin, tan } from '@botgarten/numbers'
import { numberFunction } from '../parts/number-functions.ts'

/** Angles in radians, as in Open Roberta. */
export const math_trig = numberFunction(
  'math_trig',
  'expert',
  [
    ['SIN', 'sin', sin],
    ['COS', 'cos', cos],
    ['TAN', 'tan', tan],
    ['ASIN', 'asin', asin],
    ['ACOS', 'acos', acos],
    ['ATAN', 'atan', atan],
  ],
  (py) => whole(`${py.from('math', py.field('OP', 'SIN').toLowerCase())}(${py.value('NUM')})`),
)
