import { missing } from '../parts/python.ts'
import { show, start, text } from '../parts/examples.ts'
import { connectionAt, takeLetter } from '../parts/letters.ts'
import { hidden, rows, value, words } from '../parts/looks.ts'
import { ask, fail, give, wait } from '../parts/next.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robCommunication_receiveBlock'

/** Waits for the next message of this connection. Fields as robCommunication_sendBlock. */
export const robCommunication_receiveBlock: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'messages',
    shape: 'value',
    output: 'String',
    fields: [hidden('TYPE', 'String'), hidden('PROTOCOL', 'BLUETOOTH'), hidden('CHANNEL', '-1')],
    inputs: [value('CONNECTION', 'Connection')],
    mutation: { datatype: 'String' },
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('CONNECTION')], (frame, context) => {
    const from = connectionAt(frame, 0)
    if (from === null) return fail('notConnected')
    const letter = takeLetter(context, 'text', from)
    return letter === null ? wait : give(letter.text)
  }),
  python: missing('messages'),
  example: [
    start,
    show({
      type,
      mutation: { attrs: { datatype: 'String' } },
      fields: { TYPE: 'String', PROTOCOL: 'BLUETOOTH', CHANNEL: '-1' },
      values: { CONNECTION: { type: 'robCommunication_startConnection', values: { ADDRESS: text('Bo 2') } } },
    }),
  ],
}
