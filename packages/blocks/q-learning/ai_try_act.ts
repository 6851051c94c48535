import { rows, words } from '../parts/looks.ts'
import { done, fail, wait } from '../parts/next.ts'
import { tryProgram } from '../parts/trying-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_try_act'

/** One decision by the table, without exploring, and as long as it is held; the loop's way back is the last of its ticks. */
export const ai_try_act: Definition = {
  type,
  pack: 'learning',
  look: { category: 'q-learning', shape: 'statement', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  run(_block, frame, { trying }) {
    if (!trying) return done
    if (frame.stage === 0) {
      const held = trying.act()
      if (typeof held === 'string') return fail(held)
      frame.counter = held
    }
    return ++frame.stage < (frame.counter ?? 0) ? wait : done
  },
  python: (py) => py.table(),
  example: tryProgram(),
}
