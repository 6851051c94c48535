import { number, show, start } from '../parts/examples.ts'
import { rows, statements, value, words } from '../parts/looks.ts'
import { waitFor } from '../parts/waits.ts'
import type { Definition } from '../types.ts'

const type = 'robControls_wait_for'

/** Waits until one of WAIT0, WAIT1, … is true (mutation `wait`: how many more than one), then carries out its DO. */
export const robControls_wait_for: Definition = {
  type,
  look: {
    category: 'control',
    shape: 'statement',
    fields: [],
    inputs: [value('WAIT0', 'Boolean'), statements('DO0')],
    branches: { attribute: 'wait', value: 'WAIT', most: 30 },
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: waitFor,
  example: [
    start,
    {
      type,
      values: {
        WAIT0: {
          type: 'robSensors_key_getSample',
          fields: { MODE: 'PRESSED', SENSORPORT: 'LEFT', SLOT: '' },
        },
      },
    },
    show(number(2)),
  ],
}
