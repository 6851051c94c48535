import { doubled, showTwice } from '../parts/function-examples.ts'
import { start } from '../parts/examples.ts'
import { askArgs, calls } from '../parts/functions.ts'
import { typedBy } from '../parts/kinds.ts'
import { rows, words } from '../parts/looks.ts'
import type { Definition } from '../types.ts'

const type = 'robProcedures_callreturn'

/** As robProcedures_callnoreturn; mutation `output_type`: type of the result. */
export const robProcedures_callreturn: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'program',
  look: {
    category: 'functions',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [],
    args: true,
    typed: typedBy({ attribute: 'output_type' }, { output: 'type' }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: askArgs,
  python: calls,
  example: [start, showTwice, doubled],
}
