import { whole } from '../python.ts'
import { show, start, text as textBlock } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'text'

export const text: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'text',
    shape: 'value',
    output: 'String',
    fields: [{ name: 'TEXT', kind: 'text', preset: '' }],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: (block) => give(field(block, 'TEXT')),
  python: (py) => whole(py.quote(py.field('TEXT'))),
  example: [start, show(textBlock('Bo'))],
}
