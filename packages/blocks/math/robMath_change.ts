import { isNumber } from '../parts/python.ts'
import { number, show } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { assign, declared, targetOf, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robMath_change'

/** VAR names the variable: a block `variables_get`, which is not asked. */
export const robMath_change: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'statement',
    fields: [],
    inputs: [{ name: 'VAR', kind: 'value', accepts: ['Number'], target: true }, value('DELTA', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('DELTA')], (frame, { memory }, block) => {
    const name = targetOf(block)
    const before = memory.get(name)
    if (typeof before !== 'number') return fail('noSuchVariable', { name })
    const sum = before + numberAt(frame, 0)
    if (!Number.isFinite(sum)) return fail('tooBigNumber')
    return assign(memory, name, sum)
  }),
  python: (py) => {
    const delta = py.value('DELTA')
    const sign = isNumber(delta) && delta.startsWith('-') ? '-' : '+'
    py.line(`${py.variable(targetOf(py.block))} ${sign}= ${sign === '-' ? delta.slice(1) : delta}`)
  },
  example: [
    declared('x', 'Number', number(1)),
    { type, values: { VAR: variable('x'), DELTA: number(2) } },
    show(variable('x')),
  ],
}
