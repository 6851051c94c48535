import { filledNames } from '../parts/python.ts'
import { binds, whole } from '../python.ts'
import { number, show, start, text } from '../parts/examples.ts'
import { kinds } from '../parts/kinds.ts'
import { grown } from '../parts/lists.ts'
import { rows, words } from '../parts/looks.ts'
import { ask } from '../parts/next.ts'
import { plugged, rowCount, rowName } from '../parts/rows.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'robText_join'

/** ADD0, ADD1, … (mutation `items`) as one text. */
export const robText_join: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'text',
    shape: 'value',
    output: 'String',
    fields: [],
    inputs: [],
    items: { prefix: 'ADD', min: 0, max: 99, accepts: kinds, fresh: text('Bo') },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    const count = rowCount(block)
    while (frame.stage < count) {
      const row = rowName(frame.stage++)
      if (plugged(block, row)) return ask(row)
    }
    return grown(frame.got.map(textOf).join(''))
  },
  python: (py) => {
    const rows = filledNames(py.block)
    const texts = rows.map((row) => py.text(row, rows.length > 1 ? binds.sum : binds.any))
    if (texts.length === 0) return whole('""')
    return { code: texts.join(' + '), binds: texts.length > 1 ? binds.sum : binds.whole }
  },
  example: [
    start,
    show({ type, mutation: { attrs: { items: '2' } }, values: { ADD0: text('Bo '), ADD1: number(2) } }),
  ],
}
