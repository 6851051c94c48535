import { number, show, start } from '../parts/examples.ts'
import { hidden, rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_start'

export const robControls_start: Definition = {
  type,
  look: {
    category: 'control',
    shape: 'hat',
    icon: 'play',
    fields: [hidden('DEBUG', 'FALSE')],
    inputs: [],
    mutation: { declare: 'false' },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: () => done,
  example: [start, show(number(1))],
}
