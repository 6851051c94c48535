import { whole } from '../python.ts'
import { truth } from '../parts/truths.ts'
import { lampIf, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'logic_boolean'

/** BOOL TRUE or FALSE. */
export const logic_boolean: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'logic',
    shape: 'value',
    output: 'Boolean',
    fields: [choice('BOOL', [worded('TRUE', 'true'), worded('FALSE', 'false')])],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: (block) => give(field(block, 'BOOL', 'TRUE') === 'TRUE'),
  python: (py) => whole(py.field('BOOL', 'TRUE') === 'TRUE' ? 'True' : 'False'),
  example: [start, lampIf(truth(true))],
}
