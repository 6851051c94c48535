import { netStart } from '../parts/net-examples.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { runNet } from '../parts/nets.ts'
import { execute, done, fail } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_NNstep'

const neurons = execute('IONEURON')

/** One run of the network that the start block carries (field `data`). Old files: it carries it itself, with neurons in IONEURON (see semantics.md). */
export const robActions_NNstep: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [],
    inputs: [statements('IONEURON')],
    icon: 'network',
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  run(_block, frame, context) {
    if (frame.stage++ === 0) return neurons
    return runNet(context) ? done : fail('noNetwork')
  },
  python: (py) => {
    py.body('IONEURON')
    py.step()
  },
  example: [...netStart, { type }],
}
