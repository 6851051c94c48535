// A process of its own: it prepares attacks, sends `ready`, attacks after a message, and ends with the process that started it.
import { Client } from '@botgarten/server/rehearsal'
import { attacks, type AttackName } from './attacks.ts'
import { joined, type OpenClass } from './setting.ts'

export interface Order {
  readonly url: string
  readonly class: OpenClass
  readonly cookies: readonly (readonly [string, string])[]
  readonly attacks: readonly AttackName[]
}

const stop = new AbortController()
const counts = { sent: 0, refused: 0 }
function count(status: number) {
  counts.sent++
  if (status >= 400) counts.refused++
}

async function prepared({ url, class: of, cookies, attacks: names }: Order) {
  const teacher = new Client(url)
  for (const [name, value] of cookies) teacher.cookies.set(name, value)
  // The teacher of the class is looking.
  teacher.listen(`/classes/${of.id}/stream`)
  const pupil = await joined(url, of, 'Worst')
  const target = { pupil, url, class: of, teacher, signal: stop.signal, count }
  return await Promise.all(names.map((name) => attacks[name](target)))
}

process.once('message', (order: Order) => {
  void prepared(order).then((run) => {
    process.send!('ready')
    process.on('message', (message) => {
      if (message === 'start') run.forEach((attack) => void attack())
      else process.send!(counts, () => process.exit())
    })
  })
})
process.once('unhandledRejection', (error) => {
  console.error(error)
  process.exit(1)
})
process.once('disconnect', () => process.exit())
