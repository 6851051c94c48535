import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_round'

const operations: ReadonlyMap<string, (x: number) => number> = new Map([
  ['ROUND', Math.round],
  ['ROUNDUP', Math.ceil],
  ['ROUNDDOWN', Math.floor],
])

/** Half is rounded up. */
export const math_round: Definition = {
  type,
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('OP', [
        worded('ROUND', 'round'),
        worded('ROUNDUP', 'roundUp'),
        worded('ROUNDDOWN', 'roundDown'),
      ]),
    ],
    inputs: [value('NUM', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('NUM')], (frame, _context, block) => {
    const operation = operations.get(field(block, 'OP', 'ROUND'))
    return operation === undefined ? fail('unknownChoice') : finite(operation(numberAt(frame, 0)), frame)
  }),
  example: [start, show({ type, fields: { OP: 'ROUND' }, values: { NUM: number(1) } })],
}
