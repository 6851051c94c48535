import { rangeTimes } from '../parts/python.ts'
import { number, show, start } from '../parts/examples.ts'
import { rows, statements, value, words } from '../parts/looks.ts'
import { again, ask, execute, done } from '../parts/next.ts'
import { numberAt } from '../parts/numbers.ts'
import type { Definition } from '../types.ts'

const type = 'controls_repeat_ext'
const times = ask('TIMES')
const body = execute('DO')

export const controls_repeat_ext: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'control',
    shape: 'statement',
    icon: 'repeat',
    fields: [],
    inputs: [value('TIMES', 'Number'), statements('DO')],
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  loops: true,
  /** Stages: 0 asks how often, 1 begins a pass, 2 ends one. `counter`: passes that have begun. */
  run(_block, frame) {
    if (frame.stage === 0) {
      frame.stage = 1
      return times
    }
    const begun = frame.counter ?? 0
    if (begun >= numberAt(frame, 0)) return done
    if (frame.stage === 2) {
      frame.stage = 1
      return again
    }
    frame.stage = 2
    frame.counter = begun + 1
    return body
  },
  python: (py) => py.loop(`for _ in range(${rangeTimes(py, py.value('TIMES'))}):`, 'DO'),
  example: [
    start,
    { type, values: { TIMES: number(3) }, statements: { DO: [show(number(1))] } },
    show(number(2)),
  ],
}
