import { number, show, start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'text_comment'

/** A note between the blocks. It does nothing. */
export const text_comment: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [{ name: 'TEXT', kind: 'text', preset: '' }],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: (py) => py.comment(py.field('TEXT')),
  example: [start, { type, fields: { TEXT: 'Bo' } }, show(number(1))],
}
