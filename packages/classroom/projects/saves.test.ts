import { beforeAll, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import type { Browser } from '../testing/browser.ts'
import { saveQueueOn } from './save-queue.ts'

let saves = 0
const newSave = () => `save-${++saves}-of-this-test`
const pixel = 'iVBORw0KGgo='

function save(browser: Browser, base: number, text: string, id = newSave(), project = 'project-1') {
  return browser.put(`/projects/${project}?base=${base}&save=${id}`, text)
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  let code: string
  let classId: string
  let names = 0
  const pupil = () => server.pupil(code, `Kind ${++names}`)

  beforeAll(async () => {
    server = new Server(await fresh())
    teacher = await server.firstTeacher()
    ;({ id: classId, code } = await server.openClass(teacher))
  })

  test('a save comes back as it was, and each stands on the one before', async () => {
    const { browser } = await pupil()
    expect(await save(browser, 0, projectText('a'))).toMatchObject({ status: 200, body: { revision: 1 } })
    expect(await save(browser, 1, projectText('b'))).toMatchObject({ status: 200, body: { revision: 2 } })
    const read = await browser.get('/projects/project-1')
    expect(read.body).toMatchObject({ revision: 2, project: { name: 'Garden b', card: 'friendship' } })
    const { projects } = (await browser.get('/projects')).body as { projects: object[] }
    expect(projects).toMatchObject([{ id: 'project-1', revision: 2, name: 'Garden b' }])
  })

  test('a save that is sent twice, because its answer was lost, is one', async () => {
    const { browser } = await pupil()
    const id = newSave()
    const answers = [
      await save(browser, 0, projectText('a'), id),
      await save(browser, 0, projectText('a'), id),
    ]
    expect(answers[0]!.body).toMatchObject({ revision: 1, full: false })
    expect(answers[1]).toEqual(answers[0])
    await save(browser, 1, projectText('b'))
    // Even when others came in between.
    expect((await save(browser, 0, projectText('a'), id)).body).toMatchObject({ revision: 1 })
    const { versions } = (await browser.get('/projects/project-1/versions')).body as { versions: object[] }
    expect(versions).toHaveLength(2)
  })

  test('one name for saves of two projects mixes nothing', async () => {
    const { browser } = await pupil()
    const id = newSave()
    for (const project of ['project-1', 'project-2'])
      for (const times of [1, 2])
        expect(
          await save(browser, 0, projectText(project), id, project),
          `${project} ${times}`,
        ).toMatchObject({
          ...{ status: 200, body: { revision: 1 } },
        })
    expect((await browser.get('/projects/project-2')).body).toMatchObject({
      project: { name: 'Garden project-2' },
    })
  })

  test('of a pupil who is removed while a save is checked nothing comes back', async () => {
    const { browser, id } = await pupil()
    const checkProject: Server['ports']['checkProject'] = async (text) => {
      await teacher.delete(`/classes/${classId}/pupils/${id}`)
      return server.ports.checkProject(text)
    }
    const meanwhile = new Server(server.ports.database, { checkProject, accounts: server.ports.accounts })
    meanwhile.now = server.now
    const child = meanwhile.browser()
    for (const [name, value] of browser.cookies) child.cookies.set(name, value)
    const id1 = newSave()
    expect(await save(child, 0, projectText('a'), id1)).toMatchObject({
      status: 503,
      body: { error: 'busy' },
    })
    expect(await save(child, 0, projectText('a'), id1)).toMatchObject({
      status: 401,
      body: { error: 'join' },
    })
  })

  test('a save that changes nothing is no version more, and may come twice', async () => {
    const { browser } = await pupil()
    await save(browser, 0, projectText('a'))
    const id = newSave()
    expect((await save(browser, 1, projectText('a'), id)).body).toMatchObject({ revision: 1 })
    await save(browser, 1, projectText('b'))
    expect((await save(browser, 1, projectText('a'), id)).body).toMatchObject({ revision: 1 })
    const { versions } = (await browser.get('/projects/project-1/versions')).body as { versions: object[] }
    expect(versions).toHaveLength(2)
  })

  test('of two devices on one project the second is told, and nothing is overwritten', async () => {
    const { browser } = await pupil()
    const other = browser.twin()
    await save(browser, 0, projectText('start'))
    await save(browser, 1, projectText('laptop'))
    const late = await save(other, 1, projectText('tablet'))
    expect(late).toMatchObject({ status: 409, body: { error: 'newerRevision', revision: 2 } })
    expect((await browser.get('/projects/project-1')).body).toMatchObject({
      project: { name: 'Garden laptop' },
    })
    // The child looked at both and took the tablet's: the laptop's stays among the versions.
    await save(other, 2, projectText('tablet'))
    expect((await browser.get('/projects/project-1/versions/2')).body).toMatchObject({
      project: { name: 'Garden laptop' },
    })
    expect((await browser.get('/projects/project-1')).body).toMatchObject({
      project: { name: 'Garden tablet' },
    })
  })

  test('a page that is left open sends nothing under the pupil who came after', async () => {
    const { browser, id } = await pupil()
    const path = '/projects/project-1?base=0&save=save-of-a-former-pupil'
    const send = (of: string) => browser.ask('PUT', path, projectText('a'), { 'botgarten-pupil': of })
    expect(await send('another')).toMatchObject({ status: 403, body: { error: 'otherPupil' } })
    expect((await browser.get('/projects')).body).toMatchObject({ projects: [] })
    expect((await send(id)).status).toBe(200)
  })

  test('the same work from two devices is no conflict', async () => {
    const { browser } = await pupil()
    await save(browser, 0, projectText('same'))
    expect((await save(browser.twin(), 0, projectText('same'))).body).toMatchObject({ revision: 1 })
  })

  test('two of the largest projects of one pupil are read at once; a third is refused until they are', async () => {
    const { browser } = await pupil()
    const { promise: isReading, resolve: goOn } = Promise.withResolvers<void>()
    const checkProject: Server['ports']['checkProject'] = (text) =>
      isReading.then(() => server.ports.checkProject(text))
    const slow = new Server(server.ports.database, { checkProject, accounts: server.ports.accounts })
    slow.now = server.now
    const child = slow.browser()
    for (const [name, value] of browser.cookies) child.cookies.set(name, value)
    const large = (at: number) =>
      child.put(`/projects/project-${at}?base=0&save=${newSave()}`, ' '.repeat(4_900_000))
    const sent = [large(0), large(1), large(2)]
    const refused = await Promise.race(sent)
    expect(refused).toMatchObject({ status: 429, body: { error: 'tooMuchAtOnce', seconds: 2 } })
    expect(refused.headers.get('retry-after')).toBe('2')
    goOn()
    const statuses = (await Promise.all(sent)).map(({ status }) => status)
    expect(statuses.toSorted()).toEqual([422, 422, 429])
    expect((await large(2)).status).toBe(422)
  })

  test('of twenty saves at once on one revision one is taken, and the others are told', async () => {
    const { browser } = await pupil()
    await save(browser, 0, projectText('start'))
    const all = await Promise.all(
      Array.from({ length: 20 }, (_, at) => save(browser, 1, projectText(`${at}`))),
    )
    expect(all.filter(({ status }) => status === 200)).toHaveLength(1)
    expect(all.filter(({ status }) => status === 409)).toHaveLength(19)
  })

  test('twenty children who save at once are all saved', async () => {
    const children = []
    for (let child = 0; child < 20; child++) children.push(await pupil())
    const all = await Promise.all(children.map(({ browser }, at) => save(browser, 0, projectText(`${at}`))))
    expect(all.every(({ status }) => status === 200)).toBe(true)
    for (const [at, { browser }] of children.entries())
      expect((await browser.get('/projects/project-1')).body).toMatchObject({
        project: { name: `Garden ${at}` },
      })
  })

  test('the last 20 versions can be taken back, and one an hour for a day', async () => {
    const { browser } = await pupil()
    for (let at = 0; at < 25; at++) await save(browser, at, projectText(`${at}`))
    const { versions } = (await browser.get('/projects/project-1/versions')).body as {
      versions: { revision: number }[]
    }
    expect(versions.map(({ revision }) => revision)).toEqual(Array.from({ length: 20 }, (_, at) => 25 - at))
  })

  test('a clock that is two days ahead for one save deletes no version of an earlier hour', async () => {
    const server = new Server(await fresh())
    const { code } = await server.openClass(await server.firstTeacher())
    const { browser } = await server.pupil(code, 'Fuchs')
    await save(browser, 0, projectText('first'))
    server.passes(3_600_000)
    for (let at = 1; at <= 20; at++) await save(browser, at, projectText(`${at}`))
    server.now += 2 * 24 * 3_600_000
    expect((await save(browser, 21, projectText('ahead'))).status).toBe(200)
    server.now -= 2 * 24 * 3_600_000
    const { versions } = (await browser.get('/projects/project-1/versions')).body as {
      versions: { revision: number }[]
    }
    // The newest 20 are 3 to 22; 1 is that of its hour.
    expect(versions.map(({ revision }) => revision)).toContain(1)
  })

  test('a clock that was set back loses nothing and keeps the order', async () => {
    const { browser } = await pupil()
    await save(browser, 0, projectText('first'))
    server.now -= 24 * 3_600_000
    await save(browser, 1, projectText('second'))
    server.now += 24 * 3_600_000
    expect((await browser.get('/projects/project-1')).body).toMatchObject({
      revision: 2,
      project: { name: 'Garden second' },
    })
    const { versions } = (await browser.get('/projects/project-1/versions')).body as { versions: object[] }
    expect(versions).toMatchObject([{ revision: 2 }, { revision: 1 }])
  })

  test('what the lab itself would refuse is refused', async () => {
    const { browser } = await pupil()
    const texts = ['{}', 'no json', '[]', '{"botgarten":99}', `{"a":${'['.repeat(1000)}${']'.repeat(1000)}}`]
    for (const text of texts) {
      const answer = await save(browser, 0, text)
      expect(answer).toMatchObject({ status: 422, body: { error: 'projectRefused' } })
    }
  })

  test('pictures are kept once a class, and a wrong name shows nobody another picture', async () => {
    const [one, other] = [await pupil(), await pupil()]
    const name = 'a'.repeat(64)
    const own = { type: 'image/png', base64: pixel }
    const liar = { type: 'image/png', base64: `${pixel.slice(0, -2)}8=` }
    await save(one.browser, 0, projectText('own', { [name]: own }))
    await save(one.browser, 1, projectText('own again', { [name]: own }))
    await save(other.browser, 0, projectText('lie', { [name]: liar }))
    const { db } = server.ports.database
    expect(await db.selectFrom('asset').selectAll().where('class', '=', classId).execute()).toHaveLength(2)
    expect((await one.browser.get('/projects/project-1')).body).toMatchObject({
      project: { assets: { [name]: own } },
    })
    expect((await other.browser.get('/projects/project-1')).body).toMatchObject({
      project: { assets: { [name]: liar } },
    })
  })

  test('a project that is thrown away is gone with its versions, and its place is free', async () => {
    const { browser } = await pupil()
    await save(browser, 0, projectText('a'))
    expect((await browser.delete('/projects/project-1?base=1')).status).toBe(200)
    expect((await browser.get('/projects/project-1')).status).toBe(404)
    expect((await browser.get('/projects')).body).toMatchObject({
      ...{ projects: [], bin: [{ id: 'project-1', revision: 1 }], thrown: ['project-1'] },
    })
    expect((await browser.delete('/projects/project-1?base=1')).status).toBe(404)
    // It goes on from there: what comes late is never taken for it.
    expect((await save(browser, 0, projectText('b'))).body).toMatchObject({ revision: 2 })
    expect((await browser.get('/projects')).body).toMatchObject({ projects: [{ revision: 2 }], thrown: [] })
    expect(await browser.delete('/projects/project-1?base=1')).toMatchObject({
      ...{ status: 409, body: { error: 'newerRevision', revision: 2 } },
    })
  })

  test('a revision of the same number with other work is a conflict: it is neither replaced nor deleted', async () => {
    const { browser } = await pupil()
    await save(browser, 0, projectText('a'))
    const { hash } = (await save(browser, 1, projectText('b'))).body as { hash: string }
    const other = { status: 409, body: { error: 'newerRevision', revision: 2, hash } }
    const path = '/projects/project-1?base=2'
    expect(await browser.put(`${path}&onto=another&save=${newSave()}`, projectText('c'))).toMatchObject(other)
    expect(await browser.delete(`${path}&onto=another`)).toMatchObject(other)
    expect(await browser.put(`${path}&onto=${hash}&save=${newSave()}`, projectText('c'))).toMatchObject({
      ...{ status: 200, body: { revision: 3 } },
    })
  })

  test('each change leaves a mark, and the class knows all it has given to this pupil', async () => {
    const [one, other] = [await pupil(), await pupil()]
    const listOf = async ({ browser }: typeof one, mark: string) =>
      (await browser.get(`/projects?mark=${encodeURIComponent(mark)}`)).body as {
        mark: string | null
        known: boolean
      }
    expect((await one.browser.get('/projects')).body).toMatchObject({ mark: null, known: true })
    const { mark: first } = (await save(one.browser, 0, projectText('a'))).body as { mark: string }
    const { mark: second } = (await save(one.browser, 1, projectText('b'))).body as { mark: string }
    const { mark: third } = (await one.browser.delete('/projects/project-1?base=2')).body as { mark: string }
    expect(new Set([first, second, third]).size).toBe(3)
    for (const mark of [first, second, third])
      expect(await listOf(one, mark)).toMatchObject({ mark: third, known: true })
    // A save that changes nothing leaves no mark.
    const { mark: fourth } = (await save(one.browser, 0, projectText('c'))).body as { mark: string }
    expect((await save(one.browser, 3, projectText('c'))).body).toMatchObject({ mark: fourth })
    for (const unknown of [first.replace(/^1/, '2'), `9.${first.slice(2)}`, 'nothing', ''])
      expect(await listOf(one, unknown)).toMatchObject({ known: false })
    expect(await listOf(other, first)).toMatchObject({ known: false })
  })

  test('two saves of one pupil at once leave two marks', async () => {
    const { browser } = await pupil()
    const both = await Promise.all([
      save(browser, 0, projectText('a')),
      save(browser.twin(), 0, projectText('b'), newSave(), 'project-2'),
    ])
    expect(both.map(({ status }) => status)).toEqual([200, 200])
    const marks = both.map(({ body }) => (body as { mark: string }).mark.split('.')[0])
    expect(marks.toSorted()).toEqual(['1', '2'])
  })

  test('a pupil has 100 projects at most; what is there is saved as before, and one that is deleted makes room', async () => {
    const { browser } = await pupil()
    for (let count = 0; count < 100; count++)
      expect((await save(browser, 0, projectText('a'), newSave(), `project-${count}`)).status).toBe(200)
    expect(await save(browser, 0, projectText('a'), newSave(), 'project-100')).toMatchObject({
      ...{ status: 422, body: { error: 'projectRefused', reason: 'tooManyProjects', most: 100 } },
    })
    expect((await save(browser, 1, projectText('b'), newSave(), 'project-7')).status).toBe(200)
    expect((await browser.delete('/projects/project-8?base=1')).status).toBe(200)
    expect((await save(browser, 0, projectText('a'), newSave(), 'project-100')).status).toBe(200)
  })

  test('saves are taken in after the lesson, and nothing is read before the pictures', async () => {
    const { browser } = await pupil()
    server.later(91)
    expect((await save(browser, 0, projectText('outbox'))).status).toBe(200)
    expect((await browser.get('/projects/project-1')).status).toBe(401)
    await teacher.post(`/classes/${classId}/open`)
  })

  test('from 80 % on pupil and teacher are told how full the class is', async () => {
    const { browser } = await pupil()
    expect(await save(browser, 0, projectText('a'))).toMatchObject({ body: { full: false } })
    const { db } = server.ports.database
    const row = async () =>
      (await teacher.get(`/classes/${classId}`)).body as { space: number; mostSpace: number }
    const { space, mostSpace } = await row()
    await db
      .updateTable('class')
      .set({ space: mostSpace * 0.8 })
      .where('id', '=', classId)
      .execute()
    expect(await save(browser, 1, projectText('b'))).toMatchObject({ status: 200, body: { full: true } })
    expect((await row()).space / mostSpace).toBeGreaterThan(0.8)
    await db.updateTable('class').set({ space }).where('id', '=', classId).execute()
  })

  test('when the class is full old versions go first, then the child is told and nothing is lost', async () => {
    const { browser, id } = await pupil()
    const { space } = (await teacher.get(`/classes/${classId}`)).body as { space: number }
    const size = projectText('0').length
    const { database } = server.ports
    const small = new Server(database, {
      save: saveQueueOn(database, { class: space + 3 * size, pupil: 50_000_000 }),
      accounts: server.ports.accounts,
    })
    small.now = server.now
    const child = small.browser()
    for (const [name, value] of browser.cookies) child.cookies.set(name, value)
    for (let at = 0; at < 6; at++) expect((await save(child, at, projectText(`${at}`))).status).toBe(200)
    expect((await child.get('/projects/project-1')).body).toMatchObject({ project: { name: 'Garden 5' } })
    const full = new Server(database, {
      save: saveQueueOn(database, { class: 100, pupil: 50_000_000 }),
      accounts: server.ports.accounts,
    })
    full.now = server.now
    const last = full.browser()
    for (const [name, value] of browser.cookies) last.cookies.set(name, value)
    expect(await save(last, 6, projectText('6'))).toMatchObject({ status: 507, body: { error: 'classFull' } })
    expect((await child.get('/projects/project-1')).body).toMatchObject({
      revision: 6,
      project: { name: 'Garden 5' },
    })
    expect(id).not.toBe('')
  })
})
