// Durations do not depend on the clock of the machine, which may be set at any time.
import { beforeAll, expect, test } from 'vitest'
import type { Database } from './database/database.ts'
import { firstTeacherToken } from './teaching/first-teacher.ts'
import { onBothDatabases } from './testing/databases.ts'
import { teacherOn } from './testing/teacher.ts'
import { quickAccounts, Server } from './testing/world.ts'

const [hour, day, year] = [3_600_000, 86_400_000, 365 * 86_400_000]
const jumps = [
  ['an hour ahead', hour],
  ['an hour back', -hour],
  ['a day ahead', day],
  ['a day back', -day],
  ['a year ahead', year],
  ['a year back', -year],
  // The clock shows 8 o'clock at the start.
  ['to midnight', 16 * hour],
] as const

onBothDatabases((fresh) => {
  let database: Database
  beforeAll(async () => {
    database = await fresh()
  })
  let teachers = 0
  const newServer = () => new Server(database, quickAccounts(database))
  /** The class ends later than any clock here shows: a class that has ended is hidden. */
  const openClass = async (server: Server) => {
    const teacher = await teacherOn(server)
    const made = await server.openClass(teacher)
    await teacher.patch(`/classes/${made.id}`, { endsOn: '2029-12-31' })
    return { ...made, teacher }
  }

  test.each(jumps)('a clock that is set %s leaves joining open for its 20 minutes', async (_, jump) => {
    const server = newServer()
    const { id, code, teacher } = await openClass(server)
    server.now += jump
    server.later(19)
    const { joiningUntil } = (await teacher.get(`/classes/${id}`)).body as { joiningUntil: number }
    expect(joiningUntil - server.now).toBe(60_000)
    await server.pupil(code, 'Fuchs')
    server.later(1)
    expect((await teacher.get(`/classes/${id}`)).body).toMatchObject({ pupils: 1, joiningUntil: null })
    expect((await server.browser().post('/look', { code })).status).toBe(404)
  })

  test.each(jumps)('a clock that is set %s leaves the first teacher half an hour', async (_, jump) => {
    const waits = [
      [29, 204],
      [30, 403],
    ] as const
    for (const [minutes, status] of waits) {
      await database.db.deleteFrom('operator').execute()
      const server = newServer()
      const token = await firstTeacherToken(server.ports)
      server.now += jump
      server.later(minutes)
      const made = { token, username: `teacher${++teachers}`, password: 'kastanie im regen' }
      expect((await server.browser().post('/teachers', made)).status).toBe(status)
    }
  })

  test.each(jumps)(
    'a clock that is set %s lets a device make new pupils again after ten minutes',
    async (_, jump) => {
      const server = newServer()
      const { id, code, teacher } = await openClass(server)
      const device = server.browser()
      const join = async (n: number) => (await device.post('/join', { code, nickname: `Kind ${n}` })).status
      for (let n = 0; n < 11; n++) await join(n)
      expect(await join(11)).toBe(429)
      server.now += jump
      server.later(9)
      expect(await join(11)).toBe(429)
      server.later(1)
      expect(await join(11)).toBe(201)
      await teacher.post(`/classes/${id}/close`)
    },
  )

  test.each(jumps)(
    'a clock that is set %s ends neither attention nor the visit of a teacher',
    async (_, jump) => {
      const server = newServer()
      const { id, code, teacher } = await openClass(server)
      const child = await server.pupil(code, 'Fuchs')
      const { live } = server.ports
      const view = await teacher.events(`/classes/${id}/stream`)
      await teacher.put(`/classes/${id}/attention`, { on: true })
      live.look(id, child.id, 'm.weber', 60)
      server.now += jump
      live.tick()
      expect(live.attentionOf(id)).toBe(600)
      expect(live.insideOf(child.id)).not.toBeNull()
      for (let second = 0; second < 600; second += 10) {
        server.passes(10_000)
        live.tick()
      }
      expect(live.attentionOf(id)).toBeNull()
      expect(live.insideOf(child.id)).toBeNull()
      await view.stop()
    },
  )

  test.each(jumps)(
    'a clock that is set %s lets no pupil in without pictures after 90 minutes',
    async (_, jump) => {
      const server = newServer()
      const { code } = await openClass(server)
      const child = await server.pupil(code, 'Fuchs')
      const read = async () => (await child.browser.get('/projects')).status
      server.later(30)
      server.now += jump
      server.later(61)
      expect(await read()).toBe(401)
      expect((await child.browser.post('/me/pictures', { pictures: child.pictures })).status).toBe(204)
      server.later(89)
      expect(await read()).toBe(200)
      server.later(1)
      expect(await read()).toBe(401)
    },
  )

  test.each(jumps)('a clock that is set %s leaves a form its minute to close', async (_, jump) => {
    const server = newServer()
    const { id, teacher } = await openClass(server)
    await teacher.post(`/classes/${id}/questionnaires`, { form: 'after' })
    await teacher.post(`/classes/${id}/questionnaires/after/close`)
    server.now += jump
    const state = async () => {
      const { askings } = (await teacher.get(`/classes/${id}/questionnaires`)).body as {
        askings: { state: string }[]
      }
      return askings[0]!.state
    }
    server.later(0.9)
    expect(await state()).toBe('closing')
    server.later(0.1)
    expect(await state()).toBe('closed')
  })
})
