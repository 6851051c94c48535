import { rows, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import { missing } from '../parts/python.ts'
import { practise, remember, taught } from '../parts/teaching-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_nn_remember'

/** One example: what the program's network reads in this tick, and what the motors do, the lamp, the display and the tone. */
export const ai_nn_remember: Definition = {
  type,
  pack: 'learning',
  look: { category: 'network', shape: 'statement', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  run(_block, _frame, { teaching }) {
    const problem = teaching?.remember()
    return problem ? fail(problem) : done
  },
  python: missing('examples'),
  example: taught(remember, practise(1)),
}
