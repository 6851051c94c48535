import { number, show, start } from '../parts/examples.ts'
import { decide, decision } from '../parts/decisions.ts'
import { rows, statements, value, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_if'

export const robControls_if: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [],
    inputs: [value('IF0', 'Boolean'), statements('DO0')],
    branches: { attribute: 'elseif', value: 'IF', most: 30 },
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: decide(done),
  python: decision(false),
  example: [
    start,
    {
      type,
      values: {
        IF0: { type: 'logic_compare', fields: { OP: 'LT' }, values: { A: number(1), B: number(2) } },
      },
      statements: { DO0: [show(number(1))] },
    },
  ],
}
