import { part } from '../parts/python.ts'
import { doubled, showTwice } from '../parts/function-examples.ts'
import { start } from '../parts/examples.ts'
import { kindField, typedBy } from '../parts/kinds.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { ask, execute, give } from '../parts/next.ts'
import { makeName } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robProcedures_defreturn'

const body = execute('STACK')
const result = ask('RETURN')

/** A function with a result: parameters in ST, body in STACK, result RETURN. Mutation `return_type` as TYPE. */
export const robProcedures_defreturn: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'functions',
    shape: 'function',
    fields: [makeName('function', 'f'), kindField('TYPE')],
    inputs: [
      { name: 'ST', kind: 'statements', holds: 'parameters', when: { attribute: 'declare', is: ['true'] } },
      statements('STACK'),
      { name: 'RETURN', kind: 'value', accepts: [] },
    ],
    typed: typedBy({ field: 'TYPE' }, { inputs: { RETURN: 'type' } }),
    mutation: { return_type: { field: 'TYPE' } },
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  run(_block, frame) {
    const stage = frame.stage++
    if (stage === 0) return body
    return stage === 1 ? result : give(frame.got[0] ?? null)
  },
  python: part,
  example: [start, showTwice, doubled],
}
