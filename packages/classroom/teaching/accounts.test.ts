import { beforeAll, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import { Server } from '../testing/world.ts'
import type { Browser } from '../testing/browser.ts'
import { firstTeacherToken } from './first-teacher.ts'

const password = 'kastanie im regen'

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser

  beforeAll(async () => {
    server = new Server(await fresh())
    server.holdClock()
  })

  test('until there is a teacher no class can exist', async () => {
    expect((await server.browser().get('/state')).body).toMatchObject({ firstTeacher: null })
    const answer = await server
      .browser()
      .post('/classes', { name: '5b', language: 'en', grade: 5, endsOn: '2027-01-31' })
    expect(answer.status).toBe(401)
  })

  test('the link for the first teacher lives 30 minutes, and only the newest one works', async () => {
    const [old, late] = [await firstTeacherToken(server.ports), await firstTeacherToken(server.ports)]
    const make = (token: string | null) =>
      server.browser().post('/teachers', { token, username: 'eve', password })
    expect(await make(old)).toMatchObject({ status: 403, body: { error: 'linkUsedUp' } })
    server.later(30)
    expect((await make(late)).status).toBe(403)
  })

  test('it makes one teacher, who is signed in, and works once', async () => {
    const token = await firstTeacherToken(server.ports)
    const browsers = [server.browser(), server.browser()]
    const both = await Promise.all(
      browsers.map((browser, at) => browser.post('/teachers', { token, username: `first.${at}`, password })),
    )
    expect(both.map(({ status }) => status).toSorted()).toEqual([204, 403])
    teacher = browsers[both.findIndex(({ status }) => status === 204)]!
    expect((await teacher.get('/classes')).body).toEqual({ classes: [] })
    expect(await firstTeacherToken(server.ports)).toBeNull()
    const { body } = await server.browser().get('/state')
    expect(body).toMatchObject({ firstTeacher: { madeAt: server.now } })
  })

  test('further teachers come by invitation, under a name of their own', async () => {
    const { token } = (await teacher.post('/invitations')).body as { token: string }
    const other = server.browser()
    await server.furtherTeacher(teacher, 'k.otto')
    const taken = await other.post('/teachers', { token, username: 'K.Otto', password })
    expect(taken).toMatchObject({ status: 409, body: { error: 'usernameTaken' } })
    // The link is not used up by that.
    expect((await other.post('/teachers', { token, username: 'k.otto2', password })).status).toBe(204)
    expect((await other.post('/invitations')).status).toBe(403)
  })

  test('a teacher signs in by name and password, in any capitals, and out', async () => {
    const browser = server.browser('10.9.0.1')
    expect((await browser.post('/auth/sign-in/username', { username: 'K.OTTO2', password })).status).toBe(204)
    expect((await browser.get('/auth/get-session')).body).toEqual({ teacher: { username: 'k.otto2' } })
    await browser.post('/auth/sign-out')
    expect((await browser.get('/auth/get-session')).body).toEqual({ teacher: null })
    expect((await browser.get('/classes')).status).toBe(401)
  })

  test('a wrong password and a name that nobody has are answered alike', async () => {
    const answers = []
    for (const username of ['k.otto2', 'nobody.at.all']) {
      const { status, body } = await server
        .browser('10.9.0.2')
        .post('/auth/sign-in/username', { username, password: 'wrong' })
      answers.push({ status, body })
    }
    expect(answers).toEqual(Array(2).fill({ status: 401, body: { error: 'wrongPassword' } }))
  })

  const signIn = (browser: Browser, given: string, username = 'k.otto2') =>
    browser.post('/auth/sign-in/username', { username, password: given })

  test('ten wrong passwords slow an account on unknown devices; one that has signed in before is not slowed', async () => {
    server.later(10)
    const known = server.browser('10.9.0.7')
    expect((await signIn(known, password)).status).toBe(204)
    await known.post('/auth/sign-out')
    const statuses = []
    for (let tries = 0; tries < 12; tries++) {
      const claimed = { 'x-forwarded-for': `10.8.0.${tries}` }
      const body = { username: 'K.otto2', password: `wrong ${tries}` }
      statuses.push(
        (await server.browser(`10.9.${tries}.3`).ask('POST', '/auth/sign-in/username', body, claimed)).status,
      )
    }
    // One more try comes in 15 s.
    expect(statuses).toEqual([...Array<number>(10).fill(401), 429, 429])
    expect(await signIn(server.browser('10.9.0.4'), password)).toMatchObject({
      ...{ status: 429, body: { error: 'tooManyTries' } },
    })
    expect((await signIn(known, password)).status).toBe(204)
    server.later(1)
    expect((await signIn(server.browser('10.9.0.4'), password)).status).toBe(204)
  })

  test('the mark of a known device is of one account, and cannot be made up', async () => {
    server.later(10)
    const known = server.browser('10.9.0.8')
    await signIn(known, password)
    const mark = known.cookies.get('botgarten-known')!
    server.later(10)
    for (let tries = 0; tries < 10; tries++)
      await signIn(server.browser(`10.9.${tries}.9`), 'wrong', 'm.weber.2')
    for (const made of [mark, 'device.0123456789abcdef01234567', mark.replace(/^./, '~')]) {
      const other = server.browser('10.9.1.8')
      other.cookies.set('botgarten-known', made)
      expect((await signIn(other, 'wrong', 'm.weber.2')).status).toBe(429)
    }
  })

  test('wrong passwords on a known device slow this device alone', async () => {
    server.later(10)
    const known = server.browser('10.9.0.10')
    await signIn(known, password)
    for (let tries = 0; tries < 10; tries++) expect((await signIn(known, 'wrong')).status).toBe(401)
    expect((await signIn(known, password)).status).toBe(429)
    expect((await signIn(server.browser('10.9.0.10'), password)).status).toBe(204)
    server.later(1)
    expect((await signIn(known, password)).status).toBe(204)
  })

  test('a new password from the console ends all sessions', async () => {
    const browser = server.browser('10.9.0.5')
    await browser.post('/auth/sign-in/username', { username: 'k.otto2', password })
    expect(await server.ports.accounts.reset({ username: 'K.otto2', password: 'ein neuer satz' })).toBe(true)
    expect((await browser.get('/classes')).status).toBe(401)
    expect((await browser.post('/auth/sign-in/username', { username: 'k.otto2', password })).status).toBe(401)
    const renewed = { username: 'k.otto2', password: 'ein neuer satz' }
    expect((await browser.post('/auth/sign-in/username', renewed)).status).toBe(204)
    expect(await server.ports.accounts.reset({ username: 'nobody', password })).toBe(false)
  })

  test('a session ends twelve hours after signing in, however much is done in it', async () => {
    const browser = server.browser('10.9.0.6')
    const teacher = { username: 'k.otto2', password: 'ein neuer satz' }
    const began = Date.now()
    await browser.post('/auth/sign-in/username', teacher)
    const { db } = server.ports.database
    // The one that ends last is the newest.
    const newest = () =>
      db.selectFrom('teacherSession').selectAll().orderBy('expiresAt', 'desc').executeTakeFirstOrThrow()
    const { id, expiresAt } = await newest()
    expect(Math.abs(new Date(expiresAt as string).getTime() - began - 12 * 3_600_000)).toBeLessThan(60_000)
    expect((await browser.get('/classes')).status).toBe(200)
    expect((await newest()).expiresAt).toEqual(expiresAt)
    // As it is twelve hours later.
    const past = new Date(began - 1000).toISOString()
    await db.updateTable('teacherSession').set({ expiresAt: past }).where('id', '=', id).execute()
    expect((await browser.get('/classes')).status).toBe(401)
  })

  test('a session from a time when the clock was ahead ends with the right clock', async () => {
    const browser = server.browser('10.9.0.7')
    const teacher = { username: 'k.otto2', password: 'ein neuer satz' }
    await browser.post('/auth/sign-in/username', teacher)
    expect((await browser.get('/classes')).status).toBe(200)
    const { db } = server.ports.database
    // As it was made by a clock that was an hour ahead.
    const ahead = new Date(Date.now() + 13 * 3_600_000).toISOString()
    await db.updateTable('teacherSession').set({ expiresAt: ahead }).execute()
    expect((await browser.get('/classes')).status).toBe(401)
    await browser.post('/auth/sign-in/username', teacher)
    expect((await browser.get('/classes')).status).toBe(200)
  })
})
