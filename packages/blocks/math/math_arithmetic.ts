import { binary } from '../parts/python.ts'
import { binds, whole } from '../python.ts'
import { pow } from '@botgarten/numbers'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition, Frame, Next } from '../types.ts'

const type = 'math_arithmetic'

const operations: ReadonlyMap<string, (a: number, b: number) => number> = new Map([
  ['ADD', (a, b) => a + b],
  ['MINUS', (a, b) => a - b],
  ['MULTIPLY', (a, b) => a * b],
  ['DIVIDE', (a, b) => a / b],
  ['POWER', pow],
])

const basics = [
  worded('ADD', 'plus'),
  worded('MINUS', 'minus'),
  worded('MULTIPLY', 'times'),
  worded('DIVIDE', 'dividedBy'),
]

function calculate(operator: string, frame: Frame): Next {
  const a = numberAt(frame, 0)
  const b = numberAt(frame, 1)
  if (operator === 'DIVIDE' && b === 0) return fail('divisionByZero')
  const operation = operations.get(operator)
  if (operation === undefined) return fail('unknownChoice')
  return finite(operation(a, b), frame)
}

const signs: ReadonlyMap<string, string> = new Map([
  ['ADD', '+'],
  ['MINUS', '-'],
  ['MULTIPLY', '*'],
  ['DIVIDE', '/'],
])

export const math_arithmetic: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [choice('OP', basics)],
    inputs: [value('A', 'Number'), value('B', 'Number')],
    rows: rows(type, 1),
  },
  expertLook: { fields: [choice('OP', [...basics, worded('POWER', 'power')])] },
  words: words(type),
  acts: false,
  run: afterAsking([ask('A'), ask('B')], (frame, _context, block) =>
    calculate(field(block, 'OP', 'ADD'), frame),
  ),
  python: (py) => {
    const operator = py.field('OP', 'ADD')
    if (operator === 'POWER') return whole(`pow(${py.value('A')}, ${py.value('B')})`)
    const sign = signs.get(operator) ?? py.gap('problem.unknownChoice')
    return binary(py, 'A', sign, 'B', /[+-]/.test(sign) ? binds.sum : binds.product)
  },
  example: [start, show({ type, fields: { OP: 'MULTIPLY' }, values: { A: number(6), B: number(7) } })],
}
