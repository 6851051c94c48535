import { number, show, start } from '../parts/examples.ts'
import { anyInput } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_debug'

/** Notes OUT as text; nothing is shown. */
export const robActions_debug: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [],
    inputs: [anyInput('OUT')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('OUT')], (frame, { memory }, block) => {
    memory.debug(block.id, textOf(frame.got[0]))
    return done
  }),
  python: (py) => py.line(`print(${py.text('OUT')})`),
  example: [start, { type, values: { OUT: number(1) } }, show(number(1))],
}
