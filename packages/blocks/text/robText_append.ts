import { show, text } from '../parts/examples.ts'
import { anyInput } from '../parts/kinds.ts'
import { grown } from '../parts/lists.ts'
import { rows, words } from '../parts/looks.ts'
import { ask, fail } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import { assign, declared, targetOf, variable } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robText_append'

/** VAR names the variable: a block `variables_get`, which is not asked. */
export const robText_append: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'text',
    shape: 'statement',
    fields: [],
    inputs: [{ name: 'VAR', kind: 'value', accepts: ['String'], target: true }, anyInput('TEXT')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: afterAsking([ask('TEXT')], (frame, { memory }, block) => {
    const name = targetOf(block)
    const before = memory.get(name)
    if (typeof before !== 'string') return fail('noSuchVariable', { name })
    const longer = grown(before + textOf(frame.got[0]))
    return longer.next === 'done' ? assign(memory, name, longer.value ?? null) : longer
  }),
  python: (py) => py.line(`${py.variable(targetOf(py.block))} += ${py.text('TEXT')}`),
  example: [
    declared('x', 'String', text('Bo')),
    { type, values: { VAR: variable('x', 'String'), TEXT: text('!') } },
    show(variable('x', 'String')),
  ],
}
