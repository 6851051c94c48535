import { whole } from '../python.ts'
import { show, start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'math_random_float'

/** From 0 on, below 1. */
export const math_random_float: Definition = {
  type,
  pack: 'expert',
  look: { category: 'math', shape: 'value', output: 'Number', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: false,
  run: (_block, _frame, { memory }) => give(memory.random()),
  python: (py) => whole(`${py.from('random', 'random')}()`),
  example: [start, show({ type })],
}
