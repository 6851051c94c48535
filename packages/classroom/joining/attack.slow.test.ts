import { draw, stream } from '@botgarten/numbers'
import { isLong } from '@botgarten/numbers/testing'
import { codeWords } from '@botgarten/content/codes'
import { expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import { Server, quickAccounts } from '../testing/world.ts'
import type { Answered, Browser } from '../testing/browser.ts'
import { pictures } from './pictures.ts'

const seconds = 600
/** Requests of the attacker in a second: `npm run attack:guess` sends ten times as many. */
const perSecond = isLong ? 100 : 10
const children = 30
const school = '192.0.2.1'

const secondsOf = ({ body }: Answered) => (body as { seconds: number }).seconds

onBothDatabases((fresh) => {
  test('thirty children join while an attacker guesses, also from their own address: no child waits more than 2 s', async () => {
    const database = await fresh()
    const server = new Server(database, quickAccounts(database))
    server.holdClock()
    const teacher = await server.firstTeacher()
    const { id, code } = await server.openClass(teacher)
    const known = await server.pupil(code, 'Igel')
    const chance = stream(1, 'guess')
    const below = (count: number) => Math.floor(draw(chance) * count)
    const words = codeWords('en')
    const waited = new Map<string, number>()
    const statuses = new Map<string, number>()
    let guessed = 0

    /** Codes and pictures, half of them from the school, each with the cookies of a new browser or those of the last one. */
    let last: Browser = server.browser(school)
    async function attack() {
      const from = below(2) === 0 ? school : `10.${below(4)}.${below(250)}.1`
      if (below(2) === 0) last = server.browser(from)
      const three = [0, 1, 2].map((at) => pictures[(below(4) + 4 * at) % pictures.length])
      const { status } =
        below(3) === 0
          ? await last.post('/return', { code, nickname: 'Igel', pictures: three })
          : await last.post('/look', {
              code: Array.from({ length: 4 }, () => words[below(words.length)]).join(' '),
            })
      statuses.set(`${status}`, (statuses.get(`${status}`) ?? 0) + 1)
      if (status === 200) guessed++
    }

    /** Asks as the page does: after a pause that is answered, again. */
    async function asPage(name: string, ask: () => Promise<Answered>): Promise<Answered> {
      for (;;) {
        const answer = await ask()
        if (answer.status !== 429) return answer
        waited.set(name, (waited.get(name) ?? 0) + secondsOf(answer))
        server.later(secondsOf(answer) / 60)
      }
    }

    let joined = 0
    for (let second = 0; second < seconds; second++) {
      for (let tries = 0; tries < perSecond; tries++) await attack()
      if (second % (seconds / children) === 0) {
        const name = `Kind ${joined}`
        const browser = server.browser(school)
        expect((await asPage(name, () => browser.post('/look', { code }))).status).toBe(200)
        expect((await asPage(name, () => browser.post('/join', { code, nickname: name }))).status).toBe(201)
        joined++
      }
      server.later(1 / 60)
    }
    expect(joined).toBe(children)
    expect(Math.max(0, ...waited.values())).toBeLessThanOrEqual(2)
    expect(guessed).toBe(0)
    // The pupil whose nickname was attacked gets in on its own device.
    await teacher.post(`/classes/${id}/close`)
    expect((await known.browser.post('/me/pictures', { pictures: known.pictures })).status).toBe(204)
    // The attacker was slowed: both kinds of delay were answered.
    expect([...statuses.keys()]).toEqual(expect.arrayContaining(['404', '429', '423']))
  })
})
