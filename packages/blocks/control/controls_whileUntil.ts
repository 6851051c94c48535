import { asked } from '../parts/python.ts'
import { number, show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, statements, value, worded, words } from '../parts/looks.ts'
import { again, ask, execute, done } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'controls_whileUntil'

const condition = ask('BOOL')
const body = execute('DO')

/** MODE WHILE: as long as BOOL is true · UNTIL: as long as it is not. Asked before every pass. */
export const controls_whileUntil: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'control',
    shape: 'statement',
    fields: [choice('MODE', [worded('WHILE', 'while'), worded('UNTIL', 'until')], 'UNTIL')],
    inputs: [value('BOOL', 'Boolean'), statements('DO')],
    icon: 'repeat',
    rows: rows(type, 3),
  },
  words: words(type),
  acts: false,
  loops: true,
  /** Stages: 0 asks, 1 looks at the answer, 2 ends a pass. */
  run(block, frame) {
    if (frame.stage === 0) {
      frame.stage = 1
      frame.got.length = 0
      return condition
    }
    if (frame.stage === 2) {
      frame.stage = 0
      return again
    }
    if ((frame.got[0] === true) === (field(block, 'MODE', 'UNTIL') === 'UNTIL')) return done
    frame.stage = 2
    return body
  },
  python: (py) => {
    const condition = py.expression('BOOL')
    py.loop(`while ${py.field('MODE', 'UNTIL') === 'UNTIL' ? asked(condition) : condition.code}:`, 'DO')
  },
  example: [
    start,
    {
      type,
      fields: { MODE: 'UNTIL' },
      values: {
        BOOL: { type: 'robSensors_key_getSample', fields: { MODE: 'PRESSED', SENSORPORT: 'LEFT', SLOT: '' } },
      },
      statements: { DO: [show(number(1))] },
    },
    show(number(2)),
  ],
}
