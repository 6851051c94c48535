import { part } from '../parts/python.ts'
import { doubled, showTwice } from '../parts/function-examples.ts'
import { start } from '../parts/examples.ts'
import { kindField } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { makeName } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robLocalVariables_declare'

/** A parameter: stands in ST of a function. Mutation as robGlobalVariables_declare. */
export const robLocalVariables_declare: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'program',
  look: {
    category: 'variables',
    shape: 'statement',
    fields: [makeName('variable', 'x'), kindField('TYPE')],
    inputs: [],
    mutation: { declaration_type: { field: 'TYPE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: [start, showTwice, doubled],
}
