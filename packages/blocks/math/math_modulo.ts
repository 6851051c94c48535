import { whole } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_modulo'

/** What is left; it has the sign of the dividend. */
export const math_modulo: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [value('DIVIDEND', 'Number'), value('DIVISOR', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('DIVIDEND'), ask('DIVISOR')], (frame) =>
    numberAt(frame, 1) === 0
      ? fail('divisionByZero')
      : finite(numberAt(frame, 0) % numberAt(frame, 1), frame),
  ),
  python: (py) => whole(`${py.from('math', 'fmod')}(${py.value('DIVIDEND')}, ${py.value('DIVISOR')})`),
  example: [start, show({ type, values: { DIVIDEND: number(7), DIVISOR: number(3) } })],
}
