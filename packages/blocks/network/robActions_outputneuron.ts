import { netStart } from '../parts/net-examples.ts'
import { show } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { outputIn, runNet } from '../parts/nets.ts'
import { fail } from '../parts/next.ts'
import { assign, nameField, targetOf, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_outputneuron'

/** An old block, in IONEURON of robActions_NNstep: runs the network and writes an output into the variable that the block in VALUE names. */
export const robActions_outputneuron: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n2')],
    inputs: [{ name: 'VALUE', kind: 'value', accepts: ['Number'], target: true }],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, _frame, context) {
    if (!runNet(context)) return fail('noNetwork')
    return assign(context.memory, targetOf(block, 'VALUE'), outputIn(context, field(block, 'NAME')))
  },
  python: (py) => {
    py.step()
    py.line(`${py.variable(targetOf(py.block, 'VALUE'))} = ${py.neuron('outputs', py.field('NAME'))}`)
  },
  example: [
    ...netStart,
    {
      type: 'robActions_NNstep',
      statements: { IONEURON: [{ type, fields: { NAME: 'n2' }, values: { VALUE: variable('x') } }] },
    },
    show(variable('x')),
  ],
}
