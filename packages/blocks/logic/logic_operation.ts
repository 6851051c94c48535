import { binds } from '../python.ts'
import { truth } from '../parts/truths.ts'
import { lampIf, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, value, worded, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'logic_operation'

const first = ask('A')
const second = ask('B')

/** B is asked only when A does not decide. */
export const logic_operation: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'logic',
    shape: 'value',
    output: 'Boolean',
    fields: [choice('OP', [worded('AND', 'and'), worded('OR', 'or')])],
    inputs: [value('A', 'Boolean'), value('B', 'Boolean')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block, frame) {
    if (frame.stage === 0) {
      frame.stage = 1
      return first
    }
    const decides = field(block, 'OP', 'AND') === 'OR'
    if (frame.stage === 1 && (frame.got[0] === true) !== decides) {
      frame.stage = 2
      return second
    }
    return give(frame.got[frame.got.length - 1] === true)
  },
  python: (py) => {
    const how = py.field('OP', 'AND') === 'OR' ? binds.or : binds.and
    return {
      code: `${py.value('A', how)} ${how === binds.or ? 'or' : 'and'} ${py.value('B', how)}`,
      binds: how,
    }
  },
  example: [start, lampIf({ type, fields: { OP: 'AND' }, values: { A: truth(true), B: truth(false) } })],
}
