import { number, show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { kindField, typedBy } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { declared, makeName, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robGlobalVariables_declare'

/** Stands in ST of the start block (its mutation `declare` true). Mutation `declaration_type` as TYPE; `next`: does another follow? */
export const robGlobalVariables_declare: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'program',
  look: {
    category: 'variables',
    shape: 'statement',
    fields: [makeName('variable', 'x'), kindField('TYPE')],
    inputs: [{ name: 'VALUE', kind: 'value', accepts: [] }],
    typed: typedBy({ field: 'TYPE' }, { inputs: { VALUE: 'type' } }),
    mutation: { declaration_type: { field: 'TYPE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame, { memory }, block) => {
    memory.make(field(block, 'VAR'), frame.got[0] ?? null)
    return done
  }),
  python: (py) => py.line(`${py.variable(py.field('VAR'))} = ${py.value('VALUE')}`),
  example: [declared('x', 'Number', number(7)), show(variable('x'))],
}
