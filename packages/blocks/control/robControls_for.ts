import { isWhole } from '../parts/python.ts'
import { binds } from '../python.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, statements, value, words } from '../parts/looks.ts'
import { again, ask, execute, done, fail } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import { makeName, variable } from '../parts/variables.ts'
import type { Context, Definition, Frame, Next } from '../types.ts'

const type = 'robControls_for'

const from = ask('FROM')
const to = ask('TO')
const by = ask('BY')
const body = execute('DO')

function goTo(frame: Frame, stage: number, next: Next): Next {
  frame.stage = stage
  return next
}

function countOn(frame: Frame, memory: Context['memory'], name: string, step: number): Next {
  const next = Number(memory.get(name)) + step
  if (!Number.isFinite(next)) return fail('tooBigNumber')
  memory.set(name, next)
  frame.got.length = 0
  return goTo(frame, 2, to)
}

/** As short as Python takes it. */
const rangeOf = (from: string, to: string, by: string) =>
  by !== '1' ? `${from}, ${to}, ${by}` : from === '0' ? to : `${from}, ${to}`

/** VAR counts from FROM on while it is below TO, BY at a time. TO and BY are asked again for every pass. */
export const robControls_for: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [makeName('variable', 'i')],
    inputs: [value('FROM', 'Number'), value('TO', 'Number'), value('BY', 'Number'), statements('DO')],
    icon: 'repeat',
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  loops: true,
  /** Stages: 0 asks FROM, 1 makes the variable, 2 looks at TO, 3 ends a pass, 4 asks BY, 5 counts on. */
  run(block, frame, { memory }) {
    const name = field(block, 'VAR', 'i')
    const last = numberAt(frame, frame.got.length - 1)
    switch (frame.stage) {
      case 0:
        return goTo(frame, 1, from)
      case 1:
        memory.make(name, last)
        return goTo(frame, 2, to)
      case 2:
        return Number(memory.get(name)) < last ? goTo(frame, 3, body) : done
      case 3:
        return goTo(frame, 4, again)
      case 4:
        return goTo(frame, 5, by)
      default:
        return countOn(frame, memory, name, last)
    }
  },
  python: (py) => {
    const name = py.variable(py.field('VAR', 'i'))
    const [from, to, by] = [py.value('FROM'), py.value('TO'), py.value('BY')] as const
    if (py.counts(py.field('VAR', 'i')) && [from, to, by].every(isWhole) && Number(by) > 0)
      return py.loop(`for ${name} in range(${rangeOf(from, to, by)}):`, 'DO')
    py.line(`${name} = ${from}`)
    py.loop(`while ${name} < ${py.value('TO', binds.sum)}:`, 'DO', [`${name} += ${by}`])
  },
  example: [
    start,
    {
      type,
      fields: { VAR: 'i' },
      values: { FROM: number(1), TO: number(4), BY: number(1) },
      statements: { DO: [show(variable('i'))] },
    },
  ],
}
