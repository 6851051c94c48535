import { whole } from '../python.ts'
import { show, start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'logic_null'

/** Nothing: no entry, no answer. */
export const logic_null: Definition = {
  type,
  pack: 'expert',
  look: { category: 'logic', shape: 'value', output: 'any', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: false,
  run: () => give(null),
  python: () => whole('None'),
  example: [start, show({ type })],
}
