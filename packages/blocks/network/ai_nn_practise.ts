import { rows, value, words } from '../parts/looks.ts'
import { ask, done, fail, wait } from '../parts/next.ts'
import { cut, numberAt } from '../parts/numbers.ts'
import { missing } from '../parts/python.ts'
import { practise, remember, taught } from '../parts/teaching-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_nn_practise'

/** So many rounds one block practises at most. */
const mostRounds = 10_000

/** The program's network practises its examples. That takes one tick: the clock stands until the rounds are done. */
export const ai_nn_practise: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'network',
    shape: 'statement',
    fields: [],
    inputs: [value('ROUNDS', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  /** Stages: 0 asks how many rounds, 1 begins to practise, 2 goes on with the new weights. */
  run(_block, frame, { teaching }) {
    const stage = frame.stage++
    if (stage === 0) return ask('ROUNDS')
    const rounds = cut(Math.floor(numberAt(frame, 0)), 0, mostRounds)
    if (stage > 1 || !teaching || !(rounds > 0)) return done
    const problem = teaching.practise(rounds)
    return problem ? fail(problem) : wait
  },
  python: missing('practice'),
  example: taught(remember, practise(1)),
}
