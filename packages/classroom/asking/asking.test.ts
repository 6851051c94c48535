import { beforeAll, beforeEach, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'

const report = {
  ...{ card: 'friendship', project: null, checks: ['open'], failed: 0, running: true, idle: 2 },
  ...{ size: [200, 150], pose: null, trail: [] },
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  let classId: string
  let asker: Awaited<ReturnType<Server['pupil']>>
  let helper: Awaited<ReturnType<Server['pupil']>>

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
  })
  beforeEach(async () => {
    const { id, code } = await server.openClass(teacher)
    classId = id
    asker = await server.pupil(code, 'Fuchs')
    helper = await server.pupil(code, 'Eule')
    await server.pupil(code, 'Igel')
    const project = {
      ...(JSON.parse(projectText('done')) as object),
      progress: { starts: [0, 1, 2], hints: 0 },
    }
    await helper.browser.put('/projects/project-1?base=0&save=save-0001', project)
    await helper.browser.put('/me/here', report)
  })

  const allow = (asking: boolean) => teacher.put(`/classes/${classId}/gallery`, { asking })
  const asks = (to: string) => asker.browser.put('/me/question', { card: 'friendship', to })
  const meOf = async (browser: Browser) => (await browser.get('/me')).body

  test('nobody is asked until the teacher allows it', async () => {
    for (const answer of [await asker.browser.get('/me/helpers?card=friendship'), await asks(helper.id)])
      expect(answer).toMatchObject({ status: 403, body: { error: 'askingOff' } })
    expect(await meOf(asker.browser)).toMatchObject({ asked: null, questions: [] })
  })

  test('asked can be who has finished the card and is here', async () => {
    await allow(true)
    const path = '/me/helpers?card=friendship'
    expect((await asker.browser.get(path)).body).toEqual({ helpers: [{ id: helper.id, nickname: 'Eule' }] })
    expect((await helper.browser.get(path)).body).toEqual({ helpers: [] })
    expect((await asker.browser.get('/me/helpers?card=rally')).body).toEqual({ helpers: [] })
    server.later(1)
    expect((await asker.browser.get(path)).body).toEqual({ helpers: [] })
    expect((await asks(helper.id)).status).toBe(404)
  })

  test('the one who is asked sees who asks, answers, and the other sees the answer', async () => {
    await allow(true)
    expect((await asks(helper.id)).status).toBe(204)
    expect(await meOf(helper.browser)).toMatchObject({
      questions: [{ id: asker.id, by: 'Fuchs', card: 'friendship' }],
    })
    expect(await meOf(asker.browser)).toMatchObject({ asked: { to: 'Eule', answer: null } })
    await helper.browser.put(`/me/questions/${asker.id}`, { answer: 'coming' })
    expect(await meOf(helper.browser)).toMatchObject({ questions: [] })
    expect(await meOf(asker.browser)).toMatchObject({ asked: { to: 'Eule', answer: 'coming' } })
    await asker.browser.delete('/me/question')
    expect(await meOf(asker.browser)).toMatchObject({ asked: null })
    expect((await helper.browser.put(`/me/questions/${asker.id}`, { answer: 'coming' })).status).toBe(404)
  })

  test('a second question replaces the first, and all of them end with the permission and with the lesson', async () => {
    await allow(true)
    await asks(helper.id)
    await asks(helper.id)
    expect(await meOf(helper.browser)).toMatchObject({ questions: [{ by: 'Fuchs' }] })
    await allow(false)
    await allow(true)
    expect(await meOf(helper.browser)).toMatchObject({ questions: [] })
    await asks(helper.id)
    await teacher.post(`/classes/${classId}/close`)
    expect(await server.ports.database.db.selectFrom('peerQuestion').selectAll().execute()).toEqual([])
  })

  test('nobody of another class can be asked, and a removed pupil asks no more', async () => {
    await allow(true)
    const other = await server.openClass(teacher, '6a')
    const stranger = await server.pupil(other.code, 'Wolf')
    expect((await asks(stranger.id)).status).toBe(404)
    await asks(helper.id)
    await teacher.delete(`/classes/${classId}/pupils/${asker.id}`)
    expect(await meOf(helper.browser)).toMatchObject({ questions: [] })
  })
})
