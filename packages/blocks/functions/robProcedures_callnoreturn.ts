import { sayIt, saying } from '../parts/function-examples.ts'
import { start } from '../parts/examples.ts'
import { askArgs, calls } from '../parts/functions.ts'
import { rows, words } from '../parts/looks.ts'
import type { Definition } from '../types.ts'

const type = 'robProcedures_callnoreturn'

/** Mutation `name`: of the function; `args`: its parameters, whose values are ARG0, ARG1, … */
export const robProcedures_callnoreturn: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'program',
  look: {
    category: 'functions',
    shape: 'statement',
    fields: [],
    inputs: [],
    args: true,
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: askArgs,
  python: (py) => py.line(calls(py).code),
  example: [start, sayIt, saying],
}
