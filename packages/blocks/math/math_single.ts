import { exp, ln, log10, pow } from '@botgarten/numbers'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_single'

const operations: ReadonlyMap<string, (x: number) => number> = new Map([
  ['ROOT', Math.sqrt],
  ['ABS', Math.abs],
  ['NEG', (x) => 0 - x],
  ['LN', ln],
  ['LOG10', log10],
  ['EXP', exp],
  ['POW10', (x) => pow(10, x)],
  ['SQUARE', (x) => x * x],
])

export const math_single: Definition = {
  type,
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('OP', [
        worded('ROOT', 'root'),
        worded('ABS', 'absolute'),
        worded('NEG', 'negative'),
        worded('LN', 'ln'),
        worded('LOG10', 'log10'),
        worded('EXP', 'exp'),
        worded('POW10', 'pow10'),
        worded('SQUARE', 'square'),
      ]),
    ],
    inputs: [value('NUM', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('NUM')], (frame, _context, block) => {
    const operation = operations.get(field(block, 'OP', 'ROOT'))
    return operation === undefined ? fail('unknownChoice') : finite(operation(numberAt(frame, 0)), frame)
  }),
  example: [start, show({ type, fields: { OP: 'ROOT' }, values: { NUM: number(1) } })],
}
