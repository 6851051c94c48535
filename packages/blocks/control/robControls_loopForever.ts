import { forever, number, show, start } from '../parts/examples.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { again, execute } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_loopForever'
const body = execute('DO')

export const robControls_loopForever: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'control',
    shape: 'statement',
    icon: 'repeat',
    fields: [],
    inputs: [statements('DO')],
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  loops: true,
  run(_block, frame) {
    frame.stage = 1 - frame.stage
    return frame.stage === 1 ? body : again
  },
  python: (py) => py.loop('while True:', 'DO'),
  example: [start, forever(show(number(1)))],
}
