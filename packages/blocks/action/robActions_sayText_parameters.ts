import { act } from '../parts/python.ts'
import { number, start, text } from '../parts/examples.ts'
import { anyInput } from '../parts/kinds.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { cut, numberAt } from '../parts/numbers.ts'
import { speech } from '../parts/speech.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_sayText_parameters'

/** VOICESPEED and VOICEPITCH 0 to 100; 30 and 50 are a plain voice. */
export const robActions_sayText_parameters: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [],
    inputs: [anyInput('OUT'), value('VOICESPEED', 'Number'), value('VOICEPITCH', 'Number')],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: true,
  uses: 'speech',
  run: afterAsking([ask('OUT'), ask('VOICESPEED'), ask('VOICEPITCH')], (frame, context) =>
    speech(frame, context, cut(numberAt(frame, 1), 0, 100), cut(numberAt(frame, 2), 0, 100)),
  ),
  python: (py) =>
    act(py, py.robot.say(py.text('OUT'), py.value('VOICESPEED'), py.value('VOICEPITCH')), 'speech'),
  example: [start, { type, values: { OUT: text('Bo'), VOICESPEED: number(30), VOICEPITCH: number(50) } }],
}
