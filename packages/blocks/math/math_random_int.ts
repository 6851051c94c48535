import { isWhole } from '../parts/python.ts'
import { whole } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_random_int'

/** A whole number from one to the other, both included, in either order; both are rounded inwards. */
export const math_random_int: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [value('FROM', 'Number'), value('TO', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('FROM'), ask('TO')], (frame, { memory }) => {
    const least = Math.ceil(Math.min(numberAt(frame, 0), numberAt(frame, 1)))
    const most = Math.floor(Math.max(numberAt(frame, 0), numberAt(frame, 1)))
    return finite(least + Math.floor(memory.random() * Math.max(1, most - least + 1)), frame)
  }),
  python: (py) => {
    const [from, to] = [py.value('FROM'), py.value('TO')] as const
    const inOrder = isWhole(from) && isWhole(to) && Number(from) <= Number(to)
    return whole(
      inOrder ? `${py.from('random', 'randint')}(${from}, ${to})` : py.call('random_between', from, to),
    )
  },
  example: [start, show({ type, values: { FROM: number(1), TO: number(6) } })],
}
