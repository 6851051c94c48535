import { hidden, rows, words } from '../parts/looks.ts'
import { done, fail, wait } from '../parts/next.ts'
import { tryProgram } from '../parts/trying-examples.ts'
import type { Definition } from '../types.ts'

const type = 'ai_try_learn'

/**
 * The robot tries for so many simulated minutes and learns from the pay; a table that was learned for as long with the same
 * blocks is taken as it is. Hidden: α, γ, ρ, whether a bump ends a try, the seed, and the places where tries begin (`110 190, 300 70`).
 */
export const ai_try_learn: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [
      { name: 'MINUTES', kind: 'number', preset: 8, min: 0, max: 60 },
      ...[hidden('ALPHA'), hidden('GAMMA'), hidden('RHO'), hidden('ENDS'), hidden('SEED'), hidden('STARTS')],
    ],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(_block, _frame, { trying }) {
    const came = trying?.learn() ?? true
    if (typeof came === 'string') return fail(came)
    return came ? done : wait
  },
  python: (py) => py.tryOn(),
  example: tryProgram(),
}
