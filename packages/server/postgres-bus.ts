import { randomUUID } from 'node:crypto'
import pg from 'pg'
import type { Bus, Message } from '@botgarten/classroom'

const channel = 'botgarten_live'
/** By which who runs the database knows the connection. */
const name = 'botgarten-live'
/** PostgreSQL takes 8,000 bytes a notification. */
const most = 7_500
const pause = 1_000

interface Letter {
  readonly from: string
  readonly message: Message
}

/** A message as texts that PostgreSQL takes: many tiles go in several. */
export function lettersOf(from: string, message: Message): string[] {
  const letter = JSON.stringify({ from, message } satisfies Letter)
  if (message.kind !== 'tiles' || Buffer.byteLength(letter) <= most || message.tiles.length < 2)
    return Buffer.byteLength(letter) <= most ? [letter] : []
  const middle = Math.ceil(message.tiles.length / 2)
  const [first, second] = [message.tiles.slice(0, middle), message.tiles.slice(middle)]
  return [first, second].flatMap((tiles) => lettersOf(from, { ...message, tiles }))
}

/**
 * Sends to the other nodes on the same PostgreSQL, by LISTEN and NOTIFY on a connection of its own. A connection that
 * breaks is made again; whatever was sent meanwhile is lost, and `missed` is called.
 */
export function postgresBus(address: string): Bus {
  const self = randomUUID()
  let client: pg.Client | null = null
  let closed = false
  let timer: NodeJS.Timeout | undefined
  let hear: (message: Message) => void = () => {}
  let missed: () => void = () => {}

  function take({ payload }: pg.Notification) {
    const { from, message } = JSON.parse(payload ?? '{}') as Letter
    if (from !== self) hear(message)
  }

  async function connect() {
    const next = new pg.Client({ connectionString: address, application_name: name })
    const again = () => {
      if (client === next) client = null
      if (closed || timer) return
      timer = setTimeout(() => {
        timer = undefined
        void connect()
      }, pause)
      timer.unref()
    }
    next.on('error', again)
    next.on('end', again)
    next.on('notification', take)
    try {
      await next.connect()
      await next.query(`listen ${channel}`)
      if (closed) return void (await next.end())
      client = next
      missed()
    } catch {
      again()
    }
  }

  return {
    send(message) {
      for (const letter of lettersOf(self, message))
        client?.query('select pg_notify($1, $2)', [channel, letter]).catch(() => {})
    },
    listen(whenHeard, whenMissed) {
      ;[hear, missed] = [whenHeard, whenMissed]
      void connect()
    },
    async close() {
      closed = true
      clearTimeout(timer)
      await client?.end().catch(() => {})
    },
  }
}
