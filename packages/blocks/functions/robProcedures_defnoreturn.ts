import { part } from '../parts/python.ts'
import { sayIt, saying } from '../parts/function-examples.ts'
import { start } from '../parts/examples.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { execute, done } from '../parts/next.ts'
import { makeName } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robProcedures_defnoreturn'

const body = execute('STACK')

/** A function: parameters in ST (mutation `declare` true), body in STACK. */
export const robProcedures_defnoreturn: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'functions',
    shape: 'function',
    fields: [makeName('function', 'f')],
    inputs: [
      { name: 'ST', kind: 'statements', holds: 'parameters', when: { attribute: 'declare', is: ['true'] } },
      statements('STACK'),
    ],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: (_block, frame) => (frame.stage++ === 0 ? body : done),
  python: part,
  example: [start, sayIt, saying],
}
