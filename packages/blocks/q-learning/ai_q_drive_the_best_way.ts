import { learningProgram } from '../parts/learning-examples.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { execute, done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'ai_q_drive_the_best_way'
const body = execute('DO')

/** A frame for what follows the drawn way: a line follower, as it comes from the toolbox. */
export const ai_q_drive_the_best_way: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [],
    inputs: [statements('DO')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run(_block, frame) {
    frame.stage++
    return frame.stage === 1 ? body : done
  },
  // A robot that learns on a floor with stations drives from one to the next.
  python: (py) => (py.learner ? py.line(py.call('drive_best_way')) : py.body('DO')),
  example: learningProgram(),
}
