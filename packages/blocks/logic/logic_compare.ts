import { asked, compared } from '../parts/python.ts'
import { binds, type PythonAt, type Expression } from '../python.ts'
import { number, start } from '../parts/examples.ts'
import { isColour } from '../parts/colours.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { same } from '../parts/same.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition, Next, Value } from '../types.ts'

const type = 'logic_compare'
const comparable = ['Number', 'Colour', 'Boolean', 'String', 'Connection'] as const

const orders: ReadonlyMap<string, (a: number, b: number) => boolean> = new Map([
  ['EQ', (a, b) => a === b],
  ['NEQ', (a, b) => a !== b],
  ['LT', (a, b) => a < b],
  ['LTE', (a, b) => a <= b],
  ['GT', (a, b) => a > b],
  ['GTE', (a, b) => a >= b],
])

const isText = (value: Value | undefined): value is string => typeof value === 'string'

/** Texts, truths, colours and lists are equal or not; only numbers have an order. */
function compare(operator: string, a: Value | undefined, b: Value | undefined): Next {
  const order = orders.get(operator)
  if (order === undefined) return fail('unknownChoice')
  if (typeof a === 'number' && typeof b === 'number') return give(order(a, b))
  if (operator === 'EQ' || operator === 'NEQ') return give(same(a, b) === (operator === 'EQ'))
  return fail(
    isColour(a) && isColour(b)
      ? 'coloursHaveNoOrder'
      : isText(a) && isText(b)
        ? 'textsHaveNoOrder'
        : 'cannotCompare',
  )
}

const signs: ReadonlyMap<string, string> = new Map([
  ['EQ', '=='],
  ['NEQ', '!='],
  ['LT', '<'],
  ['LTE', '<='],
  ['GT', '>'],
  ['GTE', '>='],
])
const constants = ['True', 'False', 'None']

/** Python asks for `x` and `not x` where a child compares with true or false, and for `x is None`. */
function pythonCompare(py: PythonAt): Expression {
  const sign = signs.get(py.field('OP', 'EQ')) ?? py.gap('problem.unknownChoice')
  const [a, b] = [py.expression('A'), py.expression('B')] as const
  const constant = [b, a].find(({ code }) => constants.includes(code))
  const same = sign === '=='
  if (!constant || !/^[=!]=$/.test(sign))
    return compared(py.value('A', binds.sum), sign, py.value('B', binds.sum))
  const other = constant === b ? a : b
  if (constant.code === 'None' || py.kind(constant === b ? 'A' : 'B') !== 'Boolean')
    return compared(py.value(constant === b ? 'A' : 'B', binds.sum), same ? 'is' : 'is not', constant.code)
  return same === (constant.code === 'True')
    ? other
    : { code: asked(other), binds: binds.not, not: other.code }
}

export const logic_compare: Definition = {
  type,
  pack: 'core',
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
    inputs: [value('A', ...comparable), value('B', ...comparable)],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('A'), ask('B')], (frame, { memory }, block) => {
    const [a = null, b = null] = frame.got
    memory.compared = [a, b]
    return compare(field(block, 'OP', 'EQ'), a, b)
  }),
  python: pythonCompare,
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
