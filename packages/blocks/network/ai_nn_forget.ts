import { field } from '../parts/fields.ts'
import { choice, rows, words, worded } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { missing } from '../parts/python.ts'
import { forget, taught } from '../parts/teaching-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_nn_forget'
const what = choice('WHAT', [worded('EXAMPLES', 'theExamples'), worded('PRACTICE', 'thePractice')])

/** The table of the program's network is empty, or its weights are 0. */
export const ai_nn_forget: Definition = {
  type,
  pack: 'learning',
  look: { category: 'network', shape: 'statement', fields: [what], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  run(block, _frame, { teaching }) {
    teaching?.forget(field(block, 'WHAT', 'EXAMPLES') === 'PRACTICE' ? 'practice' : 'examples')
    return done
  },
  python: missing('examples'),
  example: taught(forget('EXAMPLES'), forget('PRACTICE')),
}
