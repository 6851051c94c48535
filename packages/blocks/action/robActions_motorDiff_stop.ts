import { number, start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_motorDiff_stop'

export const robActions_motorDiff_stop: Definition = {
  type,
  pack: 'core',
  look: { category: 'action', shape: 'statement', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  run(_block, _frame, { robot }) {
    robot.stop()
    return done
  },
  python: (py) => py.line(py.robot.stop()),
  example: [
    start,
    {
      type: 'robActions_motorDiff_on',
      fields: { DIRECTION: 'FOREWARD' },
      values: { POWER: number(30) },
    },
    { type: 'robControls_wait_time', values: { WAIT: number(500) } },
    { type },
  ],
}
