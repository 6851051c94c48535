import { whole } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_constrain'

export const math_constrain: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [value('VALUE', 'Number'), value('LOW', 'Number'), value('HIGH', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE'), ask('LOW'), ask('HIGH')], (frame) =>
    give(Math.min(Math.max(numberAt(frame, 0), numberAt(frame, 1)), numberAt(frame, 2)) + 0),
  ),
  python: (py) => whole(`min(max(${py.value('VALUE')}, ${py.value('LOW')}), ${py.value('HIGH')})`),
  example: [start, show({ type, values: { VALUE: number(200), LOW: number(1), HIGH: number(100) } })],
}
