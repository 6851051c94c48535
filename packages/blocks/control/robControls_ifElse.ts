import { number, show, start } from '../parts/examples.ts'
import { decide, decision } from '../parts/decisions.ts'
import { rows, statements, value, words } from '../parts/looks.ts'
import { execute } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_ifElse'

export const robControls_ifElse: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [],
    inputs: [value('IF0', 'Boolean'), statements('DO0'), statements('ELSE')],
    mutation: { else: '1' },
    branches: { attribute: 'elseif', value: 'IF', most: 30 },
    rows: rows(type, 4),
  },
  words: words(type),
  acts: false,
  run: decide(execute('ELSE')),
  python: decision(true),
  example: [
    start,
    {
      type,
      mutation: { attrs: { else: '1' } },
      values: {
        IF0: { type: 'logic_compare', fields: { OP: 'GT' }, values: { A: number(1), B: number(2) } },
      },
      statements: { DO0: [show(number(1))], ELSE: [show(number(2))] },
    },
  ],
}
