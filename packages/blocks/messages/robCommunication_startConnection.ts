import { missing } from '../parts/python.ts'
import { number, show, text } from '../parts/examples.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, fail, give } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import { declared } from '../parts/variables.ts'
import type { Definition } from '../types.ts'

const type = 'robCommunication_startConnection'

/** ADDRESS: another robot's name, or its number in the world. It is told, and the connection stands. */
export const robCommunication_startConnection: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'messages',
    shape: 'value',
    output: 'Connection',
    fields: [],
    inputs: [value('ADDRESS', 'String')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('ADDRESS')], (frame, { mail }) => {
    const name = textOf(frame.got[0])
    const other = mail?.find(name) ?? null
    if (other === null) return fail('noSuchRobot', { name })
    mail?.send(other, { kind: 'call', text: '' })
    return give(other)
  }),
  python: missing('messages'),
  example: [declared('bo', 'Connection', { type, values: { ADDRESS: text('Bo 2') } }), show(number(1))],
}
