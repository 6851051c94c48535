import { beforeAll, beforeEach, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import type { Events, Heard } from '../testing/events.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'

const here = {
  ...{ card: 'friendship', project: 'project-1', checks: ['passed', 'open'], failed: 0, running: true },
  ...{ idle: 4, size: [200, 150], pose: { x: 12, y: 30, heading: 1.5 }, trail: [1, 2, 12, 30] },
}

interface State {
  readonly attention: number | null
  readonly inside: { by: string | null } | null
  readonly hand: boolean
  readonly handouts: readonly {
    id: string
    kind: string
    text: string | null
    card: string | null
    hint: number | null
  }[]
  readonly class: { cards: readonly string[] | null; level: string | null; open: boolean }
  readonly tiles: readonly {
    nickname: string
    handAt: number | null
    live: { seenAt: number; changedAt: number } | null
  }[]
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  let open: { id: string; code: string }
  let fox: Awaited<ReturnType<Server['pupil']>>
  let otter: typeof fox
  let stream: Events
  let view: Events

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
  })
  beforeEach(async () => {
    open = await server.openClass(teacher)
    fox = await server.pupil(open.code, 'Fuchs')
    otter = await server.pupil(open.code, 'Otter')
    stream = await fox.browser.events('/me/stream')
    view = await teacher.events(`/classes/${open.id}/stream`)
    await stream.next()
    await view.next()
  })

  const of = (path = '') => `/classes/${open.id}${path}`
  /** The next state of a stream that fits. */
  async function state(events: Events, fits: (state: State) => boolean): Promise<State> {
    const flushing = events.until((heard: Heard) => heard.event === 'state' && fits(heard.data as State))
    await server.ports.live.flush()
    return (await flushing).data as State
  }

  test('a pupil reports where it is, and the teacher sees the tile with times by the clock of the server', async () => {
    await fox.browser.put('/me/here', here)
    const heard = view.until(({ event }) => event === 'tiles')
    await server.ports.live.flush()
    const { idle, ...rest } = here
    expect((await heard).data).toEqual({
      now: server.now,
      tiles: [{ id: fox.id, live: { ...rest, seenAt: server.now, changedAt: server.now - idle * 1000 } }],
    })
    const { tiles } = (await teacher.get(of('/live'))).body as State
    expect(tiles.map(({ nickname, live }) => [nickname, live?.seenAt ?? null])).toEqual([
      ['Fuchs', server.now],
      ['Otter', null],
    ])
  })

  test('nothing of a report is stored', async () => {
    await fox.browser.put('/me/here', { ...here, trail: [4321] })
    const { db } = server.ports.database
    for (const table of ['pupil', 'project', 'class', 'meta', 'result', 'handout'] as const)
      expect(JSON.stringify(await db.selectFrom(table).selectAll().execute())).not.toContain('4321')
    await teacher.post(of('/close'))
    expect(((await teacher.get(of('/live'))).body as State).tiles.every(({ live }) => live === null)).toBe(
      true,
    )
  })

  test('a report of another shape, or larger than 2 kB, is refused', async () => {
    for (const wrong of [
      { ...here, picture: 'data:' },
      { ...here, trail: Array(321).fill(1) },
      { ...here, pose: { x: 1e9, y: 0, heading: 0 } },
      { ...here, checks: ['done'] },
    ])
      expect((await fox.browser.put('/me/here', wrong)).status).toBe(400)
  })

  test('a raised hand comes first, and the teacher takes it down', async () => {
    await otter.browser.put('/me/hand', { up: true })
    const up = await state(view, ({ tiles }) => tiles[0]!.handAt !== null)
    expect(up.tiles.map(({ nickname }) => nickname)).toEqual(['Otter', 'Fuchs'])
    await fox.browser.put('/me/hand', { up: true })
    await state(stream, ({ hand }) => hand)
    await teacher.post(of(`/pupils/${fox.id}/hand-down`))
    await state(stream, ({ hand }) => !hand)
  })

  test('a hint goes to one, stays until it is put away, and is nobody else’s', async () => {
    const to = [fox.id]
    await teacher.post(of('/handouts'), { to, kind: 'hint', text: ' Look at the left eye. ' })
    await teacher.post(of('/handouts'), { to: 'all', kind: 'hint', card: 'friendship', hint: 2 })
    const { handouts } = await state(stream, (seen) => seen.handouts.length === 2)
    expect(handouts.map(({ text, card, hint }) => text ?? `${card} ${hint}`).toSorted()).toEqual([
      'Look at the left eye.',
      'friendship 2',
    ])
    const own = handouts.find(({ text }) => text !== null)!
    expect((await otter.browser.delete(`/me/handouts/${own.id}`)).status).toBe(404)
    expect((await fox.browser.delete(`/me/handouts/${own.id}`)).status).toBe(204)
    await state(stream, (seen) => seen.handouts.length === 1)
    expect(((await otter.browser.get('/me')).body as State).handouts).toHaveLength(1)
    const rows = await server.ports.database.db
      .selectFrom('handout')
      .select('text')
      .where('class', '=', open.id)
      .execute()
    expect(rows).toEqual([{ text: null }])
  })

  test('a start program is a project that the lab’s own parser has let through', async () => {
    const bad = await teacher.post(of(`/programs?to=all`), '{"botgarten":1}')
    expect(bad).toMatchObject({ status: 422, body: { error: 'projectRefused' } })
    const { body } = await teacher.post(of(`/programs?to=${fox.id}`), projectText('from the teacher'))
    expect(body).toMatchObject({ pupils: 1 })
    const { handouts } = await state(stream, (seen) => seen.handouts.length === 1)
    expect(handouts[0]).toMatchObject({ kind: 'program', text: 'Garden from the teacher' })
    const given = await fox.browser.get(`/me/handouts/${handouts[0]!.id}`)
    expect(given.body).toMatchObject({ project: { name: 'Garden from the teacher' } })
    expect((await otter.browser.get(`/me/handouts/${handouts[0]!.id}`)).status).toBe(404)
    expect(
      (await teacher.post(of('/handouts'), { to: ['a-stranger'], kind: 'program', card: 'fear' })).status,
    ).toBe(404)
  })

  test('attention reaches every screen, is taken back, and ends by itself after ten minutes', async () => {
    expect((await teacher.put(of('/attention'), { on: true })).body).toEqual({ seconds: 600 })
    await state(stream, ({ attention }) => attention === 600)
    await teacher.put(of('/attention'), { on: false })
    await state(stream, ({ attention }) => attention === null)
    await teacher.put(of('/attention'), { on: true })
    await state(stream, ({ attention }) => attention !== null)
    for (let seconds = 0; seconds < 600; seconds += 10) {
      server.passes(10_000)
      if (seconds < 590) expect(server.ports.live.attentionOf(open.id)).toBe(590 - seconds)
      server.ports.live.tick()
    }
    expect(server.ports.live.attentionOf(open.id)).toBeNull()
  })

  test('attention ends when the teacher’s stream has broken', async () => {
    await teacher.put(of('/attention'), { on: true })
    await state(stream, ({ attention }) => attention !== null)
    await view.stop()
    server.passes(15_000)
    server.ports.live.tick()
    expect(server.ports.live.attentionOf(open.id)).not.toBeNull()
    server.passes(15_000)
    server.ports.live.tick()
    await state(stream, ({ attention }) => attention === null)
  })

  test('while a teacher looks inside, the child sees who does', async () => {
    await fox.browser.put('/projects/project-1?base=0&save=save-0001', projectText('mine'))
    await fox.browser.put('/me/here', here)
    const path = of(`/pupils/${fox.id}/inside`)
    const { body } = await teacher.post(path)
    expect(body).toMatchObject({
      project: { id: 'project-1', revision: 1, project: { name: 'Garden mine' } },
    })
    await state(stream, ({ inside }) => inside?.by === 'm.weber')
    expect((await teacher.post(`${path}?known=project-1:1`)).body).toMatchObject({
      project: { project: null },
    })
    await teacher.delete(path)
    await state(stream, ({ inside }) => inside === null)
    await teacher.get(of(`/pupils/${fox.id}/projects/project-1`))
    await state(stream, ({ inside }) => inside !== null)
    server.passes(16_000)
    server.ports.live.tick()
    await state(stream, ({ inside }) => inside === null)
  })

  test('which cards and blocks are free reaches the pupils', async () => {
    await teacher.put(of('/free'), { cards: ['friendship', 'fear'], level: 'plain' })
    const seen = await state(stream, ({ class: { cards } }) => cards !== null)
    expect(seen.class).toMatchObject({ cards: ['friendship', 'fear'], level: 'plain' })
    await teacher.put(of('/free'), { cards: null, level: null })
    await state(stream, ({ class: { cards } }) => cards === null)
  })

  test('a pupil has eight streams at most, and one that is closed makes room', async () => {
    const streams = [stream]
    while (streams.length < 8) streams.push(await fox.browser.events('/me/stream'))
    const ninth = () => fox.browser.get('/me/stream')
    expect(await ninth()).toMatchObject({ status: 429, body: { error: 'tooManyStreams' } })
    await streams.pop()!.stop()
    expect((await ninth()).status).toBe(200)
    for (const one of streams) await one.stop()
  })

  test('streams end with the lesson, the pupil and the class, with their reason', async () => {
    const end = async (events: Events) => (await events.until(({ event }) => event === 'end')).data
    await teacher.delete(of(`/pupils/${otter.id}`))
    const closed = end(stream)
    await teacher.post(of('/close'))
    expect(await closed).toEqual({ reason: 'closed' })
    expect(await stream.next()).toBeNull()
    const gone = end(view)
    await teacher.delete(of(), { name: '5b' })
    expect(await gone).toEqual({ reason: 'ended' })
  })

  test('a stream does not outlive the right to it: it is opened again every ten minutes', async () => {
    server.later(10)
    const ended = stream.until(({ event }) => event === 'end')
    server.ports.live.tick()
    expect((await ended).data).toEqual({ reason: 'again' })
    server.later(90)
    expect((await fox.browser.get('/me/stream')).status).toBe(401)
  })

  test('a reader who does not read is cut off, and holds no memory', async () => {
    const slow = await otter.browser.events('/me/stream')
    for (let beats = 0; beats < 200; beats++) server.ports.live.tick()
    let heard = 0
    while ((await slow.next()) !== null) heard++
    expect(heard).toBeLessThan(70)
  })

  test('a substitute takes the class until midnight: live view and hints, no results, no deleting', async () => {
    const { token } = (await teacher.post(of('/substitute'))).body as { token: string }
    const substitute = server.browser()
    expect((await substitute.post('/substitute', { token })).body).toEqual({ id: open.id, name: '5b' })
    expect((await substitute.get('/state')).body).toMatchObject({ substitute: { class: open.id } })
    expect((await substitute.get(of('/live'))).status).toBe(200)
    await substitute.post(of('/handouts'), { to: 'all', kind: 'hint', card: 'fear', hint: 1 })
    await substitute.post(of(`/pupils/${fox.id}/inside`))
    const seen = await state(stream, ({ inside }) => inside !== null)
    expect(seen.inside).toEqual({ by: null })
    for (const path of ['/results', '/data', '/export', '/pupils'])
      expect((await substitute.get(of(path))).status).toBe(401)
    expect((await substitute.delete(of(), { name: '5b' })).status).toBe(401)
    server.later(24 * 60)
    expect((await substitute.get(of('/live'))).status).toBe(401)
    expect((await server.browser().post('/substitute', { token })).status).toBe(403)
  })

  test('results count from how many start places each card was passed, at the best of times', async () => {
    const passed = (save: number, starts: number[]) => {
      const project = { ...(JSON.parse(projectText('r')) as object), progress: { starts, hints: 0 } }
      return fox.browser.put(`/projects/project-${save}?base=0&save=save-000${save}`, JSON.stringify(project))
    }
    await passed(10, [0, 2])
    await passed(11, [1])
    expect((await teacher.get(of('/results'))).body).toMatchObject({
      cards: [{ id: 'friendship', starts: 3 }],
      pupils: [
        { nickname: 'Fuchs', done: { friendship: 2 } },
        { nickname: 'Otter', done: {} },
      ],
    })
    expect((await teacher.get(of('/results.csv?lang=de'))).body).toBe(
      '\uFEFF;Freundschaft\r\nFuchs;2/3\r\nOtter;\r\n'.slice(1),
    )
  })

  test('the data page lists what is stored, and the export holds it', async () => {
    await fox.browser.put('/projects/project-1?base=0&save=save-0001', projectText('kept'))
    expect((await teacher.get(of('/data'))).body).toMatchObject({
      ...{ pupils: 2, projects: 1, versions: 1, endsOn: '2027-01-31', mostSpace: 500_000_000 },
      goneFromBackupsOn: server.ports.day(7),
    })
    const { body } = await teacher.get(of('/export'))
    expect(JSON.parse(body as string)).toMatchObject({
      class: '5b',
      pupils: [
        { nickname: 'Fuchs', projects: [{ project: { name: 'Garden kept' } }] },
        { nickname: 'Otter' },
      ],
    })
  })
})
