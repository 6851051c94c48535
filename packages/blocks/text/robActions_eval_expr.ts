import { show, start } from '../parts/examples.ts'
import { expressionIn } from '../parts/expressions.ts'
import { ExpressionError } from '../parts/expression-tokens.ts'
import { field } from '../parts/fields.ts'
import { kindField, typedBy } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { blockFrom } from '../template.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_eval_expr'

/**
 * EXPRESSION in Open Roberta's text language is read as the blocks that mean the same; they stand in the input WRITTEN
 * (in no file). TYPE (mutation `type`) says what it gives.
 */
export const robActions_eval_expr: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'text',
    shape: 'value',
    output: 'Number',
    fields: [{ name: 'EXPRESSION', kind: 'text', preset: '1 + 2', long: true }, kindField('TYPE')],
    inputs: [],
    typed: typedBy({ field: 'TYPE' }, { output: 'type', inputs: { WRITTEN: 'type' } }),
    mutation: { type: { field: 'TYPE' } },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  written(block) {
    let count = 0
    const freshId = () => `${block.id}/${count++}`
    try {
      return { values: { WRITTEN: blockFrom(expressionIn(field(block, 'EXPRESSION')), freshId) } }
    } catch (error) {
      if (!(error instanceof ExpressionError)) throw error
      return { error: { problem: 'problem.cannotRead', facts: { place: error.at + 1 }, stops: true } }
    }
  },
  run: afterAsking([ask('WRITTEN')], (frame) => give(frame.got[0] ?? null)),
  python: (py) => py.expression('WRITTEN'),
  example: [
    start,
    show({
      type,
      mutation: { attrs: { type: 'Number' } },
      fields: { EXPRESSION: 'sqrt(9) + 2 * 3', TYPE: 'Number' },
    }),
  ],
}
