import { missing } from '../parts/python.ts'
import { number, show, start, text } from '../parts/examples.ts'
import { connectionAt } from '../parts/letters.ts'
import { hidden, rows, value, words } from '../parts/looks.ts'
import { ask, done, fail } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import { textOf } from '../parts/texts.ts'
import type { Definition } from '../types.ts'

const type = 'robCommunication_sendBlock'

/** Data are text: Open Roberta has TYPE String (mutation `datatype`), PROTOCOL BLUETOOTH, CHANNEL -1 alone. */
export const robCommunication_sendBlock: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'messages',
    shape: 'statement',
    fields: [hidden('TYPE', 'String'), hidden('PROTOCOL', 'BLUETOOTH'), hidden('CHANNEL', '-1')],
    inputs: [value('sendData', 'String'), value('CONNECTION', 'Connection')],
    mutation: { datatype: 'String' },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('sendData'), ask('CONNECTION')], (frame, { mail }) => {
    const to = connectionAt(frame, 1)
    if (mail === undefined || to === null) return fail('notConnected')
    mail.send(to, { kind: 'text', text: textOf(frame.got[0]) })
    return done
  }),
  python: missing('messages'),
  example: [
    start,
    {
      type,
      mutation: { attrs: { datatype: 'String' } },
      fields: { TYPE: 'String', PROTOCOL: 'BLUETOOTH', CHANNEL: '-1' },
      values: {
        sendData: text('Bo'),
        CONNECTION: { type: 'robCommunication_startConnection', values: { ADDRESS: text('Bo 2') } },
      },
    },
    show(number(1)),
  ],
}
