import { someList } from '../parts/lists.ts'
import { show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { plainKindField, typedBy } from '../parts/kinds.ts'
import { listAt } from '../parts/lists.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { again, ask, execute, done } from '../parts/next.ts'
import { makeName, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_forEach'

const list = ask('LIST')
const body = execute('DO')

/** VAR (of type TYPE) is each entry of LIST in turn; the list may change meanwhile. */
export const robControls_forEach: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [plainKindField('TYPE'), makeName('variable', 'item')],
    inputs: [{ name: 'LIST', kind: 'value', accepts: [] }, statements('DO')],
    icon: 'repeat',
    typed: typedBy({ field: 'TYPE' }, { inputs: { LIST: 'list' } }),
    mutation: { list_type: { field: 'TYPE' } },
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  loops: true,
  /** Stages: 0 asks for the list, 1 begins a pass, 2 ends one. `counter`: entries that have had their turn. */
  run(block, frame, { memory }) {
    if (frame.stage === 0) {
      frame.stage = 1
      return list
    }
    const entries = listAt(frame, 0)
    const at = frame.counter ?? 0
    if (at >= entries.length) return done
    if (frame.stage === 2) {
      frame.stage = 1
      return again
    }
    frame.stage = 2
    frame.counter = at + 1
    memory.make(field(block, 'VAR', 'item'), entries[at] ?? null)
    return body
  },
  python: (py) => py.loop(`for ${py.variable(py.field('VAR', 'item'))} in ${py.value('LIST')}:`, 'DO'),
  example: [
    start,
    {
      type,
      fields: { TYPE: 'Number', VAR: 'x' },
      mutation: { attrs: { list_type: 'Number' } },
      values: { LIST: someList },
      statements: { DO: [show(variable('x'))] },
    },
  ],
}
