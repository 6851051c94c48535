import { start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import { field } from '../parts/fields.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_eval_stmt'

/** Open Roberta uses it for its own tests alone, in no toolbox: an empty one does nothing, another cannot run here. */
export const robActions_eval_stmt: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'text',
    shape: 'statement',
    fields: [{ name: 'STMTEXPRESSION', kind: 'text', preset: '', long: true }],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: (block) => (field(block, 'STMTEXPRESSION').trim() === '' ? done : fail('cannotRun')),
  python: (py) => (py.field('STMTEXPRESSION').trim() === '' ? undefined : py.gap('problem.cannotRun')),
  example: [start, { type, fields: { STMTEXPRESSION: '' } }, { type: 'robActions_display_clear' }],
}
