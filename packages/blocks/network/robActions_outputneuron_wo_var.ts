import { part } from '../parts/python.ts'
import { netStart } from '../parts/net-examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { nameField } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_outputneuron_wo_var'

/** An old block, in IONEURON of robActions_NNstep: names an output whose value another block reads. */
export const robActions_outputneuron_wo_var: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [nameField('neuron', 'n2')],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: [
    ...netStart,
    { type: 'robActions_NNstep', statements: { IONEURON: [{ type, fields: { NAME: 'n2' } }] } },
  ],
}
