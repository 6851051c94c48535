import { binds } from '../python.ts'
import { truth } from '../parts/truths.ts'
import { number, show, start } from '../parts/examples.ts'
import { anyInput, typedBy } from '../parts/kinds.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'logic_ternary'

const condition = ask('IF')
const then = ask('THEN')
const otherwise = ask('ELSE')

/** Only the one of THEN and ELSE that counts is asked. */
export const logic_ternary: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'logic',
    shape: 'value',
    output: 'Number',
    fields: [],
    inputs: [value('IF', 'Boolean'), anyInput('THEN'), anyInput('ELSE')],
    typed: typedBy({ input: 'THEN' }, { output: 'type', inputs: { ELSE: 'type' } }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(_block, frame) {
    const stage = frame.stage++
    if (stage === 0) return condition
    if (stage === 1) return frame.got[0] === true ? then : otherwise
    return give(frame.got[1] ?? null)
  },
  python: (py) => {
    const [then, condition] = [py.value('THEN', binds.or), py.value('IF', binds.or)] as const
    return { code: `${then} if ${condition} else ${py.value('ELSE', binds.ternary)}`, binds: binds.ternary }
  },
  example: [start, show({ type, values: { IF: truth(true), THEN: number(1), ELSE: number(2) } })],
}
