import { acos, asin, atan, cos, sin, tan } from '@botgarten/numbers'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_trig'

const operations: ReadonlyMap<string, (x: number) => number> = new Map([
  ['SIN', sin],
  ['COS', cos],
  ['TAN', tan],
  ['ASIN', asin],
  ['ACOS', acos],
  ['ATAN', atan],
])

/** Angles in radians, as in Open Roberta. */
export const math_trig: Definition = {
  type,
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('OP', [
        worded('SIN', 'sin'),
        worded('COS', 'cos'),
        worded('TAN', 'tan'),
        worded('ASIN', 'asin'),
        worded('ACOS', 'acos'),
        worded('ATAN', 'atan'),
      ]),
    ],
    inputs: [value('NUM', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('NUM')], (frame, _context, block) => {
    const operation = operations.get(field(block, 'OP', 'SIN'))
    return operation === undefined ? fail('unknownChoice') : finite(operation(numberAt(frame, 0)), frame)
  }),
  example: [start, show({ type, fields: { OP: 'SIN' }, values: { NUM: number(1) } })],
}
