import { placeAt } from '../parts/python.ts'
import { binds, whole } from '../python.ts'
import { number, show, start, text } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'text_cast_char_toNumber'

/** The number in Unicode of the letter at place AT, counted from 0. */
export const text_cast_char_toNumber: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'text',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [value('VALUE', 'String'), value('AT', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE'), ask('AT')], (frame) => {
    const code = textOf(frame.got[0]).charCodeAt(Math.trunc(numberAt(frame, 1)))
    return Number.isNaN(code) ? fail('noSuchLetter') : give(code)
  }),
  python: (py) => whole(`ord(${py.value('VALUE', binds.whole)}[${placeAt(py, 'AT')}])`),
  example: [start, show({ type, values: { VALUE: text('A'), AT: number(0) } })],
}
