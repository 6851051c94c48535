import { placeAt } from '../parts/python.ts'
import { whole } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'math_cast_toChar'

/** The letter with this number in Unicode. */
export const math_cast_toChar: Definition = {
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
  run: afterAsking([ask('VALUE')], (frame) => {
    const code = Math.trunc(numberAt(frame, 0))
    return code >= 0 && code <= 65535 ? give(String.fromCharCode(code)) : fail('noSuchLetter')
  }),
  python: (py) => whole(`chr(${placeAt(py, 'VALUE')})`),
  example: [start, show({ type, values: { VALUE: number(65) } })],
}
