import { missing } from '../parts/python.ts'
import { number, show } from '../parts/examples.ts'
import { takeLetter } from '../parts/letters.ts'
import { rows, words } from '../parts/looks.ts'
import { give, wait } from '../parts/next.ts'
import { declared } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robCommunication_waitForConnection'

/** Waits until another robot starts a connection. */
export const robCommunication_waitForConnection: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'messages',
    shape: 'value',
    output: 'Connection',
    fields: [],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run(_block, _frame, context) {
    const letter = takeLetter(context, 'call', null)
    return letter === null ? wait : give(letter.from)
  },
  python: missing('messages'),
  example: [declared('bo', 'Connection', { type }), show(number(1))],
}
