import { beforeAll, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import { Server, quickAccounts } from '../testing/world.ts'
import type { Browser } from '../testing/browser.ts'
import { pauseAfter, triesAfter } from './picture-limits.ts'
import { pictures } from './pictures.ts'

const wrongOf = (three: readonly string[]) => [three[1], three[0], three[2]]
const noCode = 'acorn badger cactus dove'
/** 12 · 11 · 10: three different ones of twelve, in an order. */
const secrets = pictures.length * (pictures.length - 1) * (pictures.length - 2)

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    server.holdClock()
    teacher = await server.firstTeacher()
  })

  /** Tries pictures of a nickname, each time from another address and without a cookie. @returns how often each status came */
  async function guess(tries: number, shown: { code: string; nickname: string; pictures: unknown }) {
    const statuses: Record<number, number> = {}
    for (let count = 0; count < tries; count++) {
      const { status } = await server.browser(`10.1.${count}.7`).post('/return', shown)
      statuses[status] = (statuses[status] ?? 0) + 1
    }
    return statuses
  }

  const lockedIn = async (id: string) =>
    (
      (await teacher.get(`/classes/${id}/pupils`)).body as { pupils: { lockedAt: number | null }[] }
    ).pupils.map(({ lockedAt }) => lockedAt !== null)

  test('however much one address has guessed, the right code passes from there and from everywhere', async () => {
    const { code } = await server.openClass(teacher)
    const answers = new Set<string>()
    for (let tries = 0; tries < 220; tries++) {
      const { status, body } = await server.browser('10.3.0.1').post('/look', { code: noCode })
      answers.add(`${status} ${(body as { error: string }).error}`)
    }
    expect(answers).toEqual(new Set(['404 noOpenClass', '429 tooManyTries']))
    expect((await server.browser('10.3.0.1').post('/look', { code })).status).toBe(200)
    expect((await server.browser('10.3.0.2').post('/look', { code })).status).toBe(200)
    // A delay is a header, never an open connection.
    const slowed = await server.browser('10.3.0.1').post('/look', { code: noCode })
    expect(Number(slowed.headers.get('retry-after'))).toBe(30)
    server.later(60)
    expect((await server.browser('10.3.0.1').post('/look', { code: noCode })).status).toBe(404)
  })

  test('addresses of one IPv6 network are counted as one', async () => {
    server.later(600)
    for (let tries = 0; tries < 60; tries++)
      await server.browser(`2001:db8::${tries}`).post('/look', { code: noCode })
    expect((await server.browser('2001:db8::ffff').post('/look', { code: noCode })).status).toBe(429)
    expect((await server.browser('2001:db8:0:1::1').post('/look', { code: noCode })).status).toBe(404)
  })

  test('codes of three words are answered as rarely as before, and the right one passes where little was tried', async () => {
    const { id } = await server.openClass(teacher)
    await server.ports.database.db
      .updateTable('class')
      .set({ code: 'kite-otte-plum' })
      .where('id', '=', id)
      .execute()
    let answered = 0
    for (let tries = 0; tries < 1200; tries++)
      answered +=
        (await server.browser(`10.4.${tries % 250}.1`).post('/look', { code: 'acorn badger cactus' }))
          .status === 404
          ? 1
          : 0
    // 1,000 at once, and one more in 0.6 s.
    expect(answered).toBeLessThan(1050)
    expect((await server.browser('10.5.0.1').post('/look', { code: 'kite otter plum' })).status).toBe(200)
    // Those of four words do not share this count.
    expect((await server.browser('10.5.0.2').post('/look', { code: noCode })).status).toBe(404)
  })

  test('a device gets a cookie only with its first wrong try', async () => {
    const { code } = await server.openClass(teacher)
    const browser = server.browser('10.6.0.1')
    await browser.get('/state')
    await browser.post('/look', { code })
    expect([...browser.cookies.keys()]).toEqual([])
    await browser.post('/look', { code: noCode })
    expect([...browser.cookies.keys()]).toEqual(['botgarten-device'])
  })

  test('pictures that others guess never lock the own device of a pupil', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Dachs')
    const wrong = { code, nickname: 'Dachs', pictures: wrongOf(child.pictures) }
    expect(await guess(40, wrong)).toEqual({ 403: 5, 423: 35 })
    const right = { code, nickname: 'Dachs', pictures: child.pictures }
    expect(await server.browser('10.1.2.1').post('/return', right)).toMatchObject({
      ...{ status: 423, body: { error: 'nicknameLocked' } },
    })
    await teacher.post(`/classes/${id}/close`)
    await teacher.post(`/classes/${id}/open`)
    expect((await child.browser.get('/projects')).status).toBe(401)
    // With the code as well, as on a page that has lost its way.
    expect((await child.browser.twin().post('/return', right)).status).toBe(200)
    expect((await child.browser.post('/me/pictures', { pictures: child.pictures })).status).toBe(204)
    expect((await child.browser.get('/projects')).status).toBe(200)
  })

  test('the teacher opens all locks of a class by one press, five times a day; new pictures always help', async () => {
    const { id, code } = await server.openClass(teacher)
    const children = [await server.pupil(code, 'Dachs'), await server.pupil(code, 'Igel')]
    const attack = async () => {
      for (const [at, nickname] of ['Dachs', 'Igel'].entries())
        await guess(20, { code, nickname, pictures: wrongOf(children[at]!.pictures) })
    }
    // Nothing is locked: a press uses nothing up.
    for (let count = 0; count < 6; count++)
      expect((await teacher.post(`/classes/${id}/unlock`)).status).toBe(204)
    for (let opened = 0; opened < 5; opened++) {
      await attack()
      expect(await lockedIn(id)).toEqual([true, true])
      expect((await teacher.post(`/classes/${id}/unlock`)).status).toBe(204)
      expect(await lockedIn(id)).toEqual([false, false])
      const right = { code, nickname: 'Igel', pictures: children[1]!.pictures }
      expect((await server.browser('10.7.0.1').post('/return', right)).status).toBe(200)
    }
    await attack()
    expect(await teacher.post(`/classes/${id}/unlock`)).toMatchObject({
      ...{ status: 409, body: { error: 'opensUsedUp' } },
    })
    const { body } = await teacher.post(`/classes/${id}/pupils/${children[1]!.id}/pictures`)
    const renewed = { code, nickname: 'Igel', pictures: (body as { pictures: string[] }).pictures }
    expect((await server.browser('10.7.0.1').post('/return', renewed)).status).toBe(200)
    expect(await lockedIn(id)).toEqual([true, false])
    // The next day all is as before; pages of older versions open one lock, which opens all.
    server.later(18 * 60)
    await teacher.post(`/classes/${id}/open`)
    expect(await lockedIn(id)).toEqual([false, false])
    await attack()
    await teacher.post(`/classes/${id}/pupils/${children[0]!.id}/unlock`)
    expect(await lockedIn(id)).toEqual([false, false])
  })

  test('a nickname that exists and one that does not are answered alike, before the lock, in it and after it', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Igel')
    const answers = async (nickname: string) => {
      const all = []
      for (let count = 0; count < 8; count++) {
        const shown = { code, nickname, pictures: wrongOf(child.pictures) }
        const { status, body } = await server.browser(`10.8.${count}.1`).post('/return', shown)
        all.push({ status, body })
      }
      return all
    }
    const before = await answers('Igel')
    expect(before.map(({ status }) => status)).toEqual([403, 403, 403, 403, 403, 423, 423, 423])
    expect(await answers('Niemand')).toEqual(before)
    await teacher.post(`/classes/${id}/unlock`)
    const after = await answers('Igel')
    expect(after.map(({ status }) => status)).toEqual([403, 403, 423, 423, 423, 423, 423, 423])
    expect(await answers('Niemand')).toEqual(after)
  })

  test('of many wrong pictures that come at once no more are compared than one after the other', async () => {
    const { code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Uhu')
    const wrong = { code, nickname: 'Uhu', pictures: wrongOf(child.pictures) }
    const all = await Promise.all(
      Array.from({ length: 40 }, (_, at) => server.browser(`10.12.${at}.1`).post('/return', wrong)),
    )
    expect(all.filter(({ status }) => status === 403)).toHaveLength(5)
    const own = await Promise.all(
      Array.from({ length: 20 }, () => child.browser.post('/me/pictures', { pictures: wrong.pictures })),
    )
    expect(own.filter(({ status }) => status === 403).length).toBeLessThanOrEqual(3)
  })

  test('a device that tries pictures on many nicknames has to wait after ten', async () => {
    const { code } = await server.openClass(teacher)
    const thief = server.browser('10.1.1.4')
    await thief.post('/look', { code: noCode })
    const statuses = []
    for (let tries = 0; tries < 12; tries++) {
      const shown = { code, nickname: `Fuchs ${tries}`, pictures: pictures.slice(0, 3) }
      statuses.push((await thief.post('/return', shown)).status)
    }
    expect(statuses).toEqual([...Array<number>(10).fill(403), 429, 429])
  })

  test('a child that is wrong on its own device waits a minute after the third time, then twice as long each time', async () => {
    const { code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Wolf')
    const wrong = { pictures: wrongOf(child.pictures) }
    const ask = (shown: unknown) => child.browser.post('/me/pictures', shown)
    for (let count = 0; count < 3; count++) expect((await ask(wrong)).status).toBe(403)
    expect(await ask({ pictures: child.pictures })).toMatchObject({ status: 429, body: { seconds: 60 } })
    server.later(1)
    expect((await ask(wrong)).status).toBe(403)
    expect(await ask(wrong)).toMatchObject({ status: 429, body: { seconds: 120 } })
    server.later(2)
    expect((await ask({ pictures: child.pictures })).status).toBe(204)
  })

  test('a thousand addresses and the own device together try less than 2 % of the pictures in a school day', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Luchs')
    const wrong = wrongOf(child.pictures)
    let tried = 0
    const began = server.now
    const count = (status: number) => (tried += status === 403 ? 1 : 0)
    // 8 hours in steps of 5 minutes: joining is always open, the child signs in elsewhere each hour, the teacher opens every lock.
    for (let step = 0; step < 96; step++) {
      await teacher.post(`/classes/${id}/open`)
      for (let from = 0; from < 6; from++) {
        const address = `10.${step}.${from}.9`
        count(
          (await server.browser(address).post('/return', { code, nickname: 'Luchs', pictures: wrong }))
            .status,
        )
      }
      count((await child.browser.post('/me/pictures', { pictures: wrong })).status)
      if (step % 12 === 0)
        await server
          .browser('10.200.0.1')
          .post('/return', { code, nickname: 'luchs', pictures: child.pictures })
      await teacher.post(`/classes/${id}/unlock`)
      server.later(5)
    }
    expect(server.now - began).toBe(8 * 3_600_000)
    expect(tried).toBeGreaterThan(20)
    expect(tried / secrets).toBeLessThan(0.02)
  })

  test('wrong passwords close the sign-in for no other teacher of the school', async () => {
    await server.furtherTeacher(teacher, 'k.otto')
    for (let tries = 0; tries < 30; tries++)
      await server
        .browser('10.9.0.3')
        .post('/auth/sign-in/username', { username: `nobody.${tries}`, password: 'wrong' })
    const right = { username: 'k.otto', password: 'ein anderer satz' }
    expect((await server.browser('10.9.0.3').post('/auth/sign-in/username', right)).status).toBe(204)
  })
})

test('the most that may be tried of 1,320 sets of pictures in a school day is 26, which is less than 2 %', () => {
  expect(secrets).toBe(1320)
  const elsewhere = triesAfter(1000)
  let own = 0
  for (let at = 0; at <= 8 * 3_600_000; at += pauseAfter(own)) own++
  expect([elsewhere, own]).toEqual([15, 11])
  expect((elsewhere + own) / secrets).toBeLessThan(0.02)
})
