import { act } from '../parts/python.ts'
import { start, text } from '../parts/examples.ts'
import { anyInput } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { speech } from '../parts/speech.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_sayText'

/** The next block comes when it has been said. */
export const robActions_sayText: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [],
    inputs: [anyInput('OUT')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  uses: 'speech',
  run: afterAsking([ask('OUT')], (frame, context) => speech(frame, context, 30, 50)),
  python: (py) => act(py, py.robot.say(py.text('OUT')), 'speech'),
  example: [start, { type, values: { OUT: text('Bo') } }],
}
