import { show, start, text } from '../parts/examples.ts'
import { anyInput } from '../parts/kinds.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { cut, numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_display_text'

// The display has 178 × 128 px, a letter 10 × 16.
const lastRow = 7
const lastColumn = 16

export const robActions_display_text: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [],
    inputs: [anyInput('OUT'), value('COL', 'Number'), value('ROW', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  uses: 'display',
  run: afterAsking([ask('OUT'), ask('COL'), ask('ROW')], (frame, { robot }) => {
    const column = cut(Math.round(numberAt(frame, 1)), 0, lastColumn)
    const row = cut(Math.round(numberAt(frame, 2)), 0, lastRow)
    robot.display(row, column, textOf(frame.got[0]))
    return done
  }),
  python: (py) => py.line(py.robot.show(py.text('OUT'), py.value('COL'), py.value('ROW'))),
  example: [start, show(text('Bo'))],
}
