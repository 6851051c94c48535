import { missing } from '../parts/python.ts'
import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_setLanguage'

/** The language Bo speaks from now on. */
export const robActions_setLanguage: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [
      choice('LANGUAGE', [
        worded('GERMAN', 'german'),
        worded('ENGLISH', 'english'),
        worded('FRENCH', 'french'),
        worded('SPANISH', 'spanish'),
        worded('ITALIAN', 'italian'),
        worded('DUTCH', 'dutch'),
        worded('FINNISH', 'finnish'),
        worded('POLISH', 'polish'),
        worded('RUSSIAN', 'russian'),
        worded('TURKISH', 'turkish'),
        worded('CZECH', 'czech'),
        worded('PORTUGUESE', 'portuguese'),
        worded('DANISH', 'danish'),
      ]),
    ],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(block, _frame, { robot }) {
    robot.language(field(block, 'LANGUAGE', 'GERMAN'))
    return done
  },
  python: missing('language'),
  example: [start, { type, fields: { LANGUAGE: 'GERMAN' } }],
}
