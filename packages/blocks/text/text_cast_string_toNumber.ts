import { of } from '../parts/python.ts'
import { show, start, text } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'text_cast_string_toNumber'

/** The number at the beginning of the text, with a decimal point or comma. */
export const text_cast_string_toNumber: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'text',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [value('VALUE', 'String')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('VALUE')], (frame) => {
    const x = Number.parseFloat(textOf(frame.got[0]).replace(',', '.'))
    return Number.isFinite(x) ? give(x + 0) : fail('notANumberText')
  }),
  python: of('to_number', 'VALUE'),
  example: [start, show({ type, values: { VALUE: text('5') } })],
}
