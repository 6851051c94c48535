import { whole } from '../python.ts'
import { number, show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { typedBy } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { declared, nameField, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'variables_get'

/** Mutation `datatype`: its type. */
export const variables_get: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'program',
  look: {
    category: 'variables',
    shape: 'value',
    output: 'Number',
    fields: [nameField('variable', 'x')],
    inputs: [],
    typed: typedBy({ attribute: 'datatype' }, { output: 'type' }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, _frame, { memory }) {
    const name = field(block, 'VAR')
    const value = memory.get(name)
    return value === undefined ? fail('noSuchVariable', { name }) : give(value)
  },
  python: (py) => whole(py.variable(py.field('VAR'))),
  example: [declared('x', 'Number', number(7)), show(variable('x'))],
}
