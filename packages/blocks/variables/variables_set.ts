import { number, show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { typedBy } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { assign, declared, nameField, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'variables_set'

/** Mutation `datatype`: type of the variable. */
export const variables_set: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'program',
  look: {
    category: 'variables',
    shape: 'statement',
    fields: [nameField('variable', 'x')],
    inputs: [{ name: 'VALUE', kind: 'value', accepts: [] }],
    typed: typedBy({ attribute: 'datatype' }, { inputs: { VALUE: 'type' } }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame, { memory }, block) =>
    assign(memory, field(block, 'VAR'), frame.got[0] ?? null),
  ),
  python: (py) => py.line(`${py.variable(py.field('VAR'))} = ${py.value('VALUE')}`),
  example: [
    declared('x', 'Number', number(7)),
    { type, mutation: { attrs: { datatype: 'Number' } }, fields: { VAR: 'x' }, values: { VALUE: number(8) } },
    show(variable('x')),
  ],
}
