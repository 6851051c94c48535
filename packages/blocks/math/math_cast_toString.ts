import { whole } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'math_cast_toString'

export const math_cast_toString: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'String',
    fields: [],
    inputs: [value('VALUE', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame) => give(textOf(frame.got[0]))),
  python: (py) => whole(py.text('VALUE')),
  example: [start, show({ type, values: { VALUE: number(5) } })],
}
