import { number, show, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking, waiting } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_wait_time'

export const robControls_wait_time: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [],
    inputs: [value('WAIT', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('WAIT')], (frame, context) => waiting(frame, context, numberAt(frame, 0))),
  python: (py) => py.line(py.robot.wait(py.value('WAIT'))),
  example: [start, { type, values: { WAIT: number(500) } }, show(number(1))],
}
