import { asked } from '../parts/python.ts'
import { binds } from '../python.ts'
import { truth } from '../parts/truths.ts'
import { lampIf, start } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'logic_negate'

export const logic_negate: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'logic',
    shape: 'value',
    output: 'Boolean',
    fields: [],
    inputs: [value('BOOL', 'Boolean')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('BOOL')], (frame) => give(frame.got[0] !== true)),
  python: (py) => {
    const condition = py.expression('BOOL')
    return {
      code: asked(condition),
      binds: condition.not === undefined ? binds.not : binds.compare,
      not: condition.code,
    }
  },
  example: [start, lampIf({ type, values: { BOOL: truth(false) } })],
}
