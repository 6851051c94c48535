import type { Entry } from '@botgarten/programs/together'
import { beforeAll, beforeEach, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'

const pixel = { type: 'image/png', base64: 'iVBORw0KGgo=' }
const here = {
  ...{ card: null, project: null, checks: [], failed: 0, running: false, idle: 0 },
  ...{ size: null, pose: null, trail: [] },
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  let classId: string
  let fox: Awaited<ReturnType<Server['pupil']>>
  let owl: Awaited<ReturnType<Server['pupil']>>
  let hare: Awaited<ReturnType<Server['pupil']>>

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
  })
  beforeEach(async () => {
    const { id, code } = await server.openClass(teacher)
    classId = id
    fox = await server.pupil(code, 'Fuchs')
    owl = await server.pupil(code, 'Eule')
    hare = await server.pupil(code, 'Hase')
    for (const { browser } of [fox, owl]) await browser.put('/me/here', here)
  })

  const invite = (from = fox, to = owl) => from.browser.post(`/pair?to=${to.id}`, projectText('p'))
  const pairOf = async ({ browser }: { browser: Browser }) =>
    ((await browser.get('/me')).body as { pair: unknown }).pair
  async function together() {
    const { id } = (await invite()).body as { id: string }
    await owl.browser.put('/pair/answer', { pair: id, yes: true })
    return id
  }
  const move = (n: number, base = 0) => ({
    ...{ n, base },
    op: { kind: 'field', program: 'main', block: 'b1', name: 'NUM', value: String(n) },
  })
  const send = ({ browser }: { browser: Browser }, ...ops: object[]) =>
    browser.post('/pair/operations', { ops })
  const entries = async ({ browser }: { browser: Browser }, from = 0) =>
    ((await browser.get(`/pair?from=${from}`)).body as { entries: Entry[] }).entries

  test('who is here can be asked, but not oneself on another device, and nobody of another class', async () => {
    expect((await fox.browser.get('/pair/mates')).body).toEqual({ mates: [{ id: owl.id, nickname: 'Eule' }] })
    expect((await invite(fox, fox)).status).toBe(404)
    const { code } = await server.openClass(teacher, '6a')
    expect((await invite(fox, await server.pupil(code, 'Wolf'))).status).toBe(404)
    expect(await pairOf(fox)).toBe(null)
  })

  test('the one who is asked accepts, and both have what they begin with', async () => {
    const { id } = (await invite()).body as { id: string }
    expect((await owl.browser.get('/pair')).status).toBe(404)
    expect(await pairOf(owl)).toMatchObject({ id, title: 'Garden p', with: 'Fuchs', accepted: false })
    expect((await fox.browser.put('/pair/answer', { pair: id, yes: true })).status).toBe(404)
    expect((await owl.browser.put('/pair/answer', { pair: id, yes: true })).status).toBe(204)
    const [a, b] = [await fox.browser.get('/pair'), await owl.browser.get('/pair')]
    expect(a.body).toMatchObject({ id, with: 'Eule', me: 'a', role: 'hand', accepted: true, length: 0 })
    expect(b.body).toMatchObject({ id, with: 'Fuchs', me: 'b', role: 'eye', entries: [] })
    expect(b.body).toMatchObject({ project: { name: 'Garden p' } })
    expect((await invite()).body).toMatchObject({ error: 'inPair' })
    expect((await invite(hare, owl)).body).toMatchObject({ error: 'mateInPair' })
  })

  test('one who says no, or who asks no more, leaves nothing', async () => {
    const { id } = (await invite()).body as { id: string }
    await owl.browser.put('/pair/answer', { pair: id, yes: false })
    await invite()
    await fox.browser.delete('/pair')
    expect((await fox.browser.delete('/pair')).status).toBe(404)
    expect(
      await server.ports.database.db.selectFrom('pair').select('id').where('class', '=', classId).execute(),
    ).toEqual([])
  })

  test('operations of both come into one order; sent twice they are one', async () => {
    await together()
    expect((await send(fox, move(1), move(2))).body).toEqual({ length: 2 })
    expect((await send(owl, move(1))).body).toEqual({ length: 3 })
    expect((await send(fox, move(1), move(2), move(3, 3))).body).toEqual({ length: 4 })
    expect((await entries(owl)).map(({ by, n }) => `${by}${n}`)).toEqual(['a1', 'a2', 'b1', 'a3'])
    expect(await entries(fox, 3)).toHaveLength(1)
  })

  test('both send at once: no place is given twice', async () => {
    await together()
    const answers = await Promise.all(
      [1, 2, 3].flatMap((n) => [
        send(fox, ...[1, 2, 3].slice(0, n).map((k) => move(k))),
        send(owl, ...[1, 2, 3].slice(0, n).map((k) => move(k))),
      ]),
    )
    expect(answers.every(({ status }) => status === 200)).toBe(true)
    const all = await entries(fox)
    expect(all).toHaveLength(6)
    for (const by of ['a', 'b'])
      expect(all.filter((one) => one.by === by).map(({ n }) => n)).toEqual([1, 2, 3])
  })

  test.each([
    ['a gap in the count', [move(2)]],
    ['what nobody can have seen', [move(1, 7)]],
    ['none', []],
    ['too many', Array.from({ length: 501 }, (_, k) => move(k + 1))],
    ['an operation that is none', [{ n: 1, base: 0, op: { kind: 'run' } }]],
    ['a reserved name', [{ n: 1, base: 0, op: { kind: 'knob', path: ['constructor'], value: 1 } }]],
  ])('%s is refused', async (_what, ops) => {
    await together()
    expect((await send(fox, ...ops)).status).toBe(400)
    expect(await entries(owl)).toEqual([])
  })

  test('so many within ten seconds, and no more', async () => {
    await together()
    const hundreds = (from: number) => Array.from({ length: 500 }, (_, k) => move(from + k))
    await send(fox, ...hundreds(1))
    await send(fox, ...hundreds(501))
    expect((await send(fox, move(1001))).body).toEqual({ error: 'tooManyTries', seconds: 10 })
    server.later(1)
    expect((await send(fox, move(1001))).status).toBe(200)
  })

  test('the other one hears at once of operations and of the hand', async () => {
    await together()
    const stream = await owl.browser.events('/me/stream')
    await stream.next()
    await send(fox, move(1))
    expect(await stream.next()).toEqual({ event: 'pair', data: { length: 1 } })
    const hand = { program: 'main', at: 'b1', x: 0.5, y: 0.25, chosen: null }
    await fox.browser.put('/pair/hand', hand)
    expect(await stream.next()).toEqual({ event: 'hand', data: hand })
  })

  test('hand and eye swap', async () => {
    await together()
    await owl.browser.put('/pair/role', { role: 'hand' })
    expect((await fox.browser.get('/pair?from=0')).body).toMatchObject({ role: 'eye' })
    await owl.browser.put('/pair/role', { role: 'eye' })
    expect((await fox.browser.get('/pair?from=0')).body).toMatchObject({ role: 'hand' })
  })

  test('who stays can still read what was done; then nothing is left of it', async () => {
    const id = await together()
    await send(fox, move(1))
    await fox.browser.delete('/pair')
    expect((await fox.browser.get('/pair')).status).toBe(404)
    expect((await owl.browser.get('/pair?from=0')).body).toMatchObject({ over: true, length: 1 })
    // Nobody has to wait for the other to look.
    expect((await invite(fox, hare)).status).toBe(201)
    await owl.browser.delete('/pair')
    expect(
      await server.ports.database.db.selectFrom('pairEntry').selectAll().where('pair', '=', id).execute(),
    ).toEqual([])
  })

  test('a project with an own photo goes to nobody', async () => {
    const project = JSON.parse(projectText('p', { ['b'.repeat(64)]: pixel })) as { world: object }
    const world = { ...project.world, floor: { asset: 'b'.repeat(64) } }
    const answer = await fox.browser.post(`/pair?to=${owl.id}`, { ...project, world })
    expect(answer.body).toMatchObject({ error: 'ownPhoto' })
  })

  test('where the teacher does not want it nobody is asked, and who was at it goes on alone', async () => {
    expect((await fox.browser.get('/me')).body).toMatchObject({ class: { together: true } })
    await together()
    await teacher.put(`/classes/${classId}/gallery`, { together: false })
    expect((await teacher.get(`/classes/${classId}/gallery`)).body).toMatchObject({
      together: false,
      on: true,
    })
    expect((await fox.browser.get('/me')).body).toMatchObject({ class: { together: false }, pair: null })
    for (const answer of [await invite(), await fox.browser.get('/pair/mates')])
      expect(answer).toMatchObject({ status: 403, body: { error: 'togetherOff' } })
    await teacher.put(`/classes/${classId}/gallery`, { together: true })
    expect((await invite()).status).toBe(201)
  })

  test('a third child reads and adds nothing, and the end of the lesson is the end of the pair', async () => {
    await together()
    expect((await hare.browser.get('/pair')).status).toBe(404)
    expect((await send(hare, move(1))).status).toBe(404)
    await teacher.post(`/classes/${classId}/close`)
    expect(
      await server.ports.database.db.selectFrom('pair').select('id').where('class', '=', classId).execute(),
    ).toEqual([])
  })

  test('when one is removed from the class the other goes on alone', async () => {
    await together()
    await teacher.delete(`/classes/${classId}/pupils/${fox.id}`)
    expect((await owl.browser.get('/pair')).status).toBe(404)
  })
})
