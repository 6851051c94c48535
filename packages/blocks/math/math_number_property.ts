import { compared } from '../parts/python.ts'
import { binds, whole } from '../python.ts'
import { properties } from '../parts/primes.ts'
import { lampIf, number, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, valueWhen, worded, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import type { Definition } from '../types.ts'

const type = 'math_number_property'

const number_ = ask('NUMBER_TO_CHECK')
const divisor = ask('DIVISOR')

const pythonProperties: ReadonlyMap<string, readonly [rest: string, sign: string, than: string]> = new Map([
  ['EVEN', [' % 2', '==', '0']],
  ['ODD', [' % 2', '==', '1']],
  ['WHOLE', [' % 1', '==', '0']],
  ['POSITIVE', ['', '>', '0']],
  ['NEGATIVE', ['', '<', '0']],
  ['DIVISIBLE_BY', ['', '==', '0']],
])

/** PROPERTY DIVISIBLE_BY has an input DIVISOR (mutation `divisor_input`). */
export const math_number_property: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Boolean',
    fields: [
      choice('PROPERTY', [
        worded('EVEN', 'even'),
        worded('ODD', 'odd'),
        worded('PRIME', 'prime'),
        worded('WHOLE', 'wholeNumber'),
        worded('POSITIVE', 'positive'),
        worded('NEGATIVE', 'belowZero'),
        worded('DIVISIBLE_BY', 'divisibleBy'),
      ]),
    ],
    inputs: [
      value('NUMBER_TO_CHECK', 'Number'),
      valueWhen('DIVISOR', { field: 'PROPERTY', is: ['DIVISIBLE_BY'] }, 'Number'),
    ],
    mutation: { divisor_input: { field: 'PROPERTY', is: ['DIVISIBLE_BY'] } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const property = field(block, 'PROPERTY', 'EVEN')
    const stage = frame.stage++
    if (stage === 0) return number_
    if (stage === 1 && property === 'DIVISIBLE_BY') return divisor
    if (property === 'DIVISIBLE_BY') {
      if (numberAt(frame, 1) === 0) return fail('divisionByZero')
      return give(numberAt(frame, 0) % numberAt(frame, 1) === 0)
    }
    const holds = properties.get(property)
    return holds === undefined ? fail('unknownChoice') : give(holds(numberAt(frame, 0)))
  },
  python: (py) => {
    const property = py.field('PROPERTY', 'EVEN')
    if (property === 'PRIME') return whole(py.call('is_prime', py.value('NUMBER_TO_CHECK')))
    const [rest, sign, than] = pythonProperties.get(property) ?? py.gap('problem.unknownChoice')
    const divisor = property === 'DIVISIBLE_BY' ? ` % ${py.value('DIVISOR', binds.sign)}` : rest
    return compared(py.value('NUMBER_TO_CHECK', divisor ? binds.product : binds.sum) + divisor, sign, than)
  },
  example: [start, lampIf({ type, fields: { PROPERTY: 'EVEN' }, values: { NUMBER_TO_CHECK: number(4) } })],
}
