import { show, start, text } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_display_clear'

export const robActions_display_clear: Definition = {
  type,
  pack: 'core',
  look: { category: 'action', shape: 'statement', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  uses: 'display',
  run(_block, _frame, { robot }) {
    robot.clearDisplay()
    return done
  },
  python: (py) => py.line(py.robot.clear()),
  example: [start, show(text('Bo')), { type }],
}
