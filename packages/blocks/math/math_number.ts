import { numberOf } from '../parts/python.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { numberIn } from '../parts/numbers.ts'
import type { Definition } from '../types.ts'

const type = 'math_number'

export const math_number: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [{ name: 'NUM', kind: 'number', preset: 0 }],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block) {
    const x = numberIn(field(block, 'NUM', '0'))
    return x === null ? fail('notANumber') : give(x)
  },
  python: (py) => numberOf(py.field('NUM', '0')) ?? py.gap('problem.notANumber'),
  example: [start, show(number(42))],
}
