import { sql } from 'kysely'
import { beforeEach, expect, test } from 'vitest'
import { migrate } from '../database/migrate.ts'
import { openSqlite } from '../database/sqlite.ts'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { endClasses, everyNight } from './every-night.ts'
import { clockDoubted } from './running-days-store.ts'

const aDay = 24 * 60

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  beforeEach(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
    await endClasses(server.ports)
  })

  /** A class with a child and its project. @param days from today until it ends */
  async function classEnding(days: number) {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Fuchs')
    await child.browser.put('/projects/project-1?base=0&save=save-0001', projectText('a'))
    await teacher.patch(`/classes/${id}`, { endsOn: server.ports.day(days) })
    return { id, code, child, status: async () => (await teacher.get(`/classes/${id}`)).status }
  }
  const signInAgain = () =>
    teacher.post('/auth/sign-in/username', { username: 'm.weber', password: 'kastanie im regen' })
  /** The server starts again after days of rest. */
  async function startAfter(days: number) {
    server.later(days * aDay)
    await signInAgain()
    await endClasses(server.ports)
  }
  const clock = async () => (await teacher.get('/clock')).body
  const answer = (right: boolean) => teacher.post('/clock', { right, today: server.ports.day(0) })

  test('a class ends on its day, before the first answer of a server that ran in the week before', async () => {
    const { status, child } = await classEnding(3)
    await startAfter(2)
    expect(await status()).toBe(200)
    await startAfter(5)
    expect(await status()).toBe(404)
    expect(await child.browser.get('/me')).toMatchObject({ status: 410, body: { error: 'classEnded' } })
  })

  test('from midnight of its last day on a class is hidden, also before it is deleted', async () => {
    const { status, child } = await classEnding(1)
    server.later(aDay)
    expect(await status()).toBe(423)
    expect((await child.browser.get('/me')).status).toBe(423)
    await everyNight(server.ports)
    expect(await status()).toBe(404)
  })

  test('14 days before the end its teacher sees the date, whether or not the server ran', async () => {
    const { id } = await classEnding(20)
    const soon = async () => ((await teacher.get(`/classes/${id}`)).body as { endsSoon: boolean }).endsSoon
    server.later(5 * aDay)
    expect(await soon()).toBe(false)
    server.later(aDay)
    await signInAgain()
    expect(await soon()).toBe(true)
  })

  test('after 8 days without running ended classes are hidden, and one press of the operator deletes them', async () => {
    const [ended, goesOn] = [await classEnding(3), await classEnding(60)]
    const lastDay = server.ports.day(0)
    await startAfter(8)
    expect(await ended.status()).toBe(423)
    expect(await goesOn.status()).toBe(200)
    expect(server.buried).toEqual([])
    expect(await clock()).toEqual({
      ...{ today: server.ports.day(0), last: lastDay, doubted: true, denied: false, days: 1, ended: 1 },
    })
    const doubted = { today: server.ports.day(0), last: lastDay, denied: false }
    expect((await server.browser().get('/state')).body).toMatchObject({ clock: doubted })
    expect((await answer(true)).status).toBe(204)
    expect(await ended.status()).toBe(404)
    expect(await goesOn.status()).toBe(200)
    expect(server.buried).toEqual([{ kind: 'class', id: ended.id }])
    expect(await clock()).toMatchObject({ doubted: false, ended: 0 })
    expect((await server.browser().get('/state')).body).toMatchObject({ clock: null })
  })

  test('an answer about another day than the clock shows now does not count', async () => {
    const { status } = await classEnding(3)
    await startAfter(8)
    const today = server.ports.day(0)
    server.later(300 * aDay)
    await signInAgain()
    expect(await teacher.post('/clock', { right: true, today })).toMatchObject({
      ...{ status: 409, body: { error: 'otherDay' } },
    })
    expect(await status()).toBe(423)
  })

  test('the clock is wrong, by the answer of the operator: ended classes are shown again and complete', async () => {
    const { status, child } = await classEnding(40)
    server.now += 300 * aDay * 60_000
    await endClasses(server.ports)
    await signInAgain()
    expect(await status()).toBe(423)
    const change = () => child.browser.put('/projects/project-1?base=1&save=save-0002', projectText('b'))
    expect((await change()).status).toBe(423)
    expect((await answer(false)).status).toBe(204)
    expect(await status()).toBe(200)
    for (let night = 0; night < 20; night++) {
      server.now += aDay * 60_000
      await everyNight(server.ports)
    }
    expect((await change()).body).toMatchObject({ revision: 2 })
    // The clock is set right: without a doubt everything is as before.
    server.now -= 320 * aDay * 60_000
    await endClasses(server.ports)
    await signInAgain()
    expect(await clock()).toMatchObject({ doubted: false })
    expect(await status()).toBe(200)
  })

  test('without an answer a class is deleted on the 14th different day of running', async () => {
    const { status } = await classEnding(3)
    await startAfter(30)
    for (let day = 2; day < 14; day++) await startAfter(1)
    await startAfter(0)
    expect(await status()).toBe(423)
    await startAfter(1)
    expect(await status()).toBe(404)
  })

  test.each([
    ['before the last day of running', -40],
    ['more than a year after it', 366],
  ])('while the clock is %s nothing is ever deleted', async (_, days) => {
    const { status } = await classEnding(3)
    server.now += days * aDay * 60_000
    const { db } = server.ports.database
    await db.updateTable('class').set({ endsOn: '2020-01-01' }).execute()
    for (let night = 0; night < 30; night++) {
      await everyNight(server.ports)
      expect(await clockDoubted(db, server.ports.day)).toBe(true)
      server.now += aDay * 60_000
    }
    await signInAgain()
    expect(await status()).toBe(423)
    expect(server.buried).toEqual([])
  })

  test('while the clock is doubted no link and no counted try is cleared away', async () => {
    const { token } = (await teacher.post('/invitations')).body as { token: string }
    server.now += 300 * aDay * 60_000
    await everyNight(server.ports)
    server.now -= 300 * aDay * 60_000
    await everyNight(server.ports)
    const made = { token, username: 'k.otto', password: 'ein anderer satz' }
    expect((await server.browser().post('/teachers', made)).status).toBeLessThan(300)
  })

  test('open pages are sent away at once when their class is hidden, and are refused from then on', async () => {
    const { child } = await classEnding(3)
    const stream = await child.browser.events('/me/stream')
    server.now += 300 * aDay * 60_000
    await endClasses(server.ports)
    await stream.until(({ event }) => event === 'end')
    expect(await stream.next()).toBeNull()
    expect((await child.browser.get('/me/stream')).status).toBe(423)
  })

  test('the last day that an earlier version ran on is taken over', async () => {
    const { db } = server.ports.database
    await db.deleteFrom('meta').where('key', '=', 'running days').execute()
    await db.insertInto('meta').values({ key: 'days', value: '12 2026-10-01' }).execute()
    expect(await clock()).toMatchObject({ last: '2026-10-01', doubted: true })
    await db.updateTable('meta').set({ value: '12 2026-11-20' }).where('key', '=', 'days').execute()
    expect(await clock()).toMatchObject({ last: server.ports.day(0), doubted: false })
  })

  test('three nodes that look at the clock at once delete a class once and agree', async () => {
    const { id } = await classEnding(3)
    server.later(5 * aDay)
    await Promise.all([1, 2, 3].map(() => endClasses(server.ports)))
    expect(server.buried.every((one) => one.id === id)).toBe(true)
    await signInAgain()
    expect(await clock()).toMatchObject({ last: server.ports.day(0), doubted: false, ended: 0 })
  })
})

test('a disk that takes no note of the day does not stop the deletion of a class that has ended', async () => {
  const database = openSqlite(':memory:')
  await migrate(database)
  const server = new Server(database, quickAccounts(database))
  const teacher = await server.firstTeacher()
  const { id } = await server.openClass(teacher)
  await teacher.patch(`/classes/${id}`, { endsOn: server.ports.day(1) })
  await endClasses(server.ports)
  for (const change of ['insert', 'update'])
    await sql
      .raw(`create trigger "no ${change}" before ${change} on meta begin select raise(abort, 'full'); end`)
      .execute(database.db)
  server.later(aDay)
  expect(await endClasses(server.ports)).toBe(false)
  expect(server.buried).toEqual([{ kind: 'class', id }])
  await database.close()
})
