// `node scripts/study-log.ts > packages/experiments/study/reference/log.jsonl`: what three made-up sittings write. study.py reads it.
import { addBlocks, knowMaps } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { createLab, type Lab } from '@botgarten/lab'
import { penFor, pseudonymOf, recorded, type Entry } from '@botgarten/experiments/study'

addBlocks(learning)
knowMaps(content)

interface Hands {
  readonly lab: Lab
  readonly write: (entry: Entry) => void
  /** Real time goes by, in milliseconds; with it so much simulated time, in ticks. */
  readonly wait: (milliseconds: number, ticks?: number) => void
  readonly open: (place: string, program?: string) => void
}

function sitting(session: string, group: number, child: number, acts: (hands: Hands) => void): void {
  let t = 0
  const pen = penFor(
    { session, pseudonym: pseudonymOf(group, child) },
    () => t,
    (line) => process.stdout.write(`${JSON.stringify(line)}\n`),
  )
  const order = group === 1 ? ['net', 'q'] : ['q', 'net']
  pen.write({ event: 'session', format: 1, version: '0.1.0', study: 'example', group, seed: 7, order })
  let now: ReturnType<typeof recorded> | null = null
  const open = (place: string, program = 'start') => {
    now?.end()
    const { card, world } = content.card(place)!
    const document = cardDocument(world, card, content.program(place, program)!, 0)
    const lab = createLab()
    lab.load(document, content.floorOf(document.world), { seed: 1, checks: card.checks })
    now = recorded(lab, pen, { place, seed: 1 })
  }
  const wait = (milliseconds: number, ticks = 0) => {
    t += milliseconds
    for (let left = ticks; left > 0; left -= 30) {
      now?.lab.advance(Math.min(30, left))
      now?.lab.view()
    }
  }
  const lab = new Proxy({} as Lab, { get: (_, name: keyof Lab) => now!.lab[name] })
  acts({ lab, write: pen.write, wait, open })
  now = now as ReturnType<typeof recorded> | null
  now?.end()
  pen.write({ event: 'over' })
}

function turn({ lab, wait }: Hands, at: number, to: number): void {
  const [brain, { weights }] = Object.entries(lab.document().brains)[0]!
  const links = Object.entries(weights).flatMap(([from, row]) =>
    Object.keys(row).map((end) => [from, end] as const),
  )
  const [from, end] = links[at]!
  for (let part = 1; part <= 4; part++) {
    lab.setWeight(brain, from, end, (to * part) / 4)
    wait(120)
  }
}

sitting('s5e55104a', 1, 1, (hands) => {
  const { lab, write, wait, open } = hands
  write({ event: 'part', module: 'net' })
  open('friendship')
  wait(41_250)
  lab.start()
  wait(6000, 300)
  turn(hands, 0, 0.8)
  wait(2000, 90)
  turn(hands, 1, 0.6)
  turn(hands, 0, 0.7)
  wait(1500)
  turn(hands, 0, 0.5)
  lab.stop()
  write({ event: 'hint', shown: 1 })
  wait(9000)
  open('friendship', 'solution')
  lab.start()
  wait(20_000, 1200)
})
sitting('s7a11e500', 2, 1, ({ lab, wait, open }) => {
  open('fear', 'solution')
  wait(12_345)
  lab.step('network')
  lab.step('network')
  wait(3000)
  lab.start()
  wait(15_000, 900)
  lab.start()
  wait(5000, 240)
})
sitting('s00c0ffee', 2, 2, ({ write, wait, open }) => {
  open('friendship')
  wait(60_000)
  write({ event: 'hint', shown: 1 })
  write({ event: 'rest' })
  wait(30_000)
})
sitting('s5e55104b', 1, 1, ({ lab, wait, open }) => {
  open('fear')
  wait(4000)
  lab.edit({ ...lab.document().programs })
  lab.start()
  wait(2000, 120)
})
