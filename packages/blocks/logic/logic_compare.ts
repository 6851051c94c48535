import { number, start } from '../parts/examples.ts'
import { isColour } from '../parts/colours.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition, Next, Value } from '../types.ts'

const type = 'logic_compare'

const orders: ReadonlyMap<string, (a: number, b: number) => boolean> = new Map([
  ['EQ', (a, b) => a === b],
  ['NEQ', (a, b) => a !== b],
  ['LT', (a, b) => a < b],
  ['LTE', (a, b) => a <= b],
  ['GT', (a, b) => a > b],
  ['GTE', (a, b) => a >= b],
])

function compareColours(operator: string, a: string, b: string): Next {
  if (operator !== 'EQ' && operator !== 'NEQ') return fail('coloursHaveNoOrder')
  return give((a.toUpperCase() === b.toUpperCase()) === (operator === 'EQ'))
}

function compare(operator: string, a: Value | undefined, b: Value | undefined): Next {
  if (isColour(a) && isColour(b)) return compareColours(operator, a, b)
  if (typeof a !== 'number' || typeof b !== 'number') return fail('cannotCompare')
  const order = orders.get(operator)
  return order === undefined ? fail('unknownChoice') : give(order(a, b))
}

export const logic_compare: Definition = {
  type,
  look: {
    category: 'logic',
    shape: 'value',
    output: 'Boolean',
    fields: [
      choice('OP', [
        worded('EQ', 'equal'),
        worded('NEQ', 'notEqual'),
        worded('LT', 'less'),
        worded('LTE', 'lessOrEqual'),
        worded('GT', 'greater'),
        worded('GTE', 'greaterOrEqual'),
      ]),
    ],
    inputs: [value('A', 'Number', 'Colour'), value('B', 'Number', 'Colour')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('A'), ask('B')], (frame, _context, block) =>
    compare(field(block, 'OP', 'EQ'), frame.got[0], frame.got[1]),
  ),
  example: [
    start,
    {
      type: 'robControls_if',
      values: { IF0: { type, fields: { OP: 'GT' }, values: { A: number(2), B: number(1) } } },
      statements: {
        DO0: [{ type: 'actions_bricklight_on_ev3', fields: { COLOUR: 'GREEN', MODE: 'ON' } }],
      },
    },
  ],
}
