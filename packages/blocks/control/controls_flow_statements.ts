import { forever, number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import type { Definition, Next } from '../types.ts'

const type = 'controls_flow_statements'

const loop: Next = { next: 'leave', how: 'loop' }
const pass: Next = { next: 'leave', how: 'pass' }

/** FLOW BREAK: leaves the innermost loop · CONTINUE: leaves its pass. */
export const controls_flow_statements: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [choice('FLOW', [worded('BREAK', 'leaveLoop'), worded('CONTINUE', 'nextPass')])],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: (block) => (field(block, 'FLOW', 'BREAK') === 'CONTINUE' ? pass : loop),
  python: (py) => {
    const endings = py.endings()
    if (py.field('FLOW', 'BREAK') !== 'CONTINUE') return py.line('break')
    for (const line of endings) py.line(line)
    py.line('continue')
  },
  example: [start, forever(show(number(1)), { type, fields: { FLOW: 'BREAK' } }), show(number(2))],
}
