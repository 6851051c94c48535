import { rows, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { missing } from '../parts/python.ts'
import { practise, remember, taught } from '../parts/teaching-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_nn_error'

/** How far the program's network is off its examples, as it is in this tick: the root of the mean square, in percent. */
export const ai_nn_error: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'network',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(_block, _frame, { teaching }) {
    if (!teaching) return give(0)
    const error = teaching.error()
    return typeof error === 'string' ? fail(error) : give(error)
  },
  python: missing('practice'),
  example: taught(remember, practise(1)),
}
