import { sayIt, saying } from '../parts/function-examples.ts'
import { start } from '../parts/examples.ts'
import { typedBy } from '../parts/kinds.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robProcedures_ifreturn'

const condition = ask('CONDITION')
const result = ask('VALUE')

/** Leaves the function when CONDITION is true. Mutation `value` 1: with the result VALUE (of `return_type`), 0: without. */
export const robProcedures_ifreturn: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'functions',
    shape: 'statement',
    fields: [],
    inputs: [
      value('CONDITION', 'Boolean'),
      { name: 'VALUE', kind: 'value', accepts: [], when: { attribute: 'value', is: ['1'] } },
    ],
    typed: typedBy({ attribute: 'return_type' }, { inputs: { VALUE: 'type' } }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const stage = frame.stage++
    if (stage === 0) return condition
    if (frame.got[0] !== true) return done
    if (stage === 1 && block.mutation?.attrs.value === '1') return result
    return { next: 'return', value: frame.got[1] ?? null }
  },
  python: (py) => {
    py.line(`if ${py.value('CONDITION')}:`)
    py.inner(() => py.line(py.block.mutation?.attrs.value === '1' ? `return ${py.value('VALUE')}` : 'return'))
  },
  example: [start, sayIt, saying],
}
