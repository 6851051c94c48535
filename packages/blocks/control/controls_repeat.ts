import { rangeTimes } from '../parts/python.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, statements, words } from '../parts/looks.ts'
import { again, execute, done, fail } from '../parts/next.ts'
import { numberIn } from '../parts/numbers.ts'
import type { Definition } from '../types.ts'

const type = 'controls_repeat'

const body = execute('DO')

/** An old block: field TIMES instead of an input. */
export const controls_repeat: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [{ name: 'TIMES', kind: 'number', preset: 10, min: 0, step: 1 }],
    inputs: [statements('DO')],
    icon: 'repeat',
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  loops: true,
  run(block, frame) {
    const times = numberIn(field(block, 'TIMES', '10'))
    if (times === null) return fail('notANumber')
    const begun = frame.counter ?? 0
    if (begun >= times) return done
    if (frame.stage === 1) {
      frame.stage = 0
      return again
    }
    frame.stage = 1
    frame.counter = begun + 1
    return body
  },
  python: (py) => py.loop(`for _ in range(${rangeTimes(py, py.field('TIMES', '10'))}):`, 'DO'),
  example: [start, { type, fields: { TIMES: '3' }, statements: { DO: [show(number(1))] } }],
}
