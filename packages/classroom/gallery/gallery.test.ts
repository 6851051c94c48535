import { beforeAll, beforeEach, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'

interface Item {
  readonly id: string
  readonly title: string
  readonly by: string
  readonly own: boolean
  readonly hearts: number
  readonly mine: boolean
  readonly hidden: boolean
  readonly waiting: boolean
  readonly photo: boolean
  readonly world: { readonly size: object }
}
interface Page {
  readonly total: number
  readonly items: readonly Item[]
}

const pixel = { type: 'image/png', base64: 'iVBORw0KGgo=' }
const withPhoto = (mark: string) => projectText(mark, { ['b'.repeat(64)]: pixel })

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  let classId: string
  let fox: Awaited<ReturnType<Server['pupil']>>
  let owl: Awaited<ReturnType<Server['pupil']>>
  let count = 0

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
  })

  const answerOf = (by: Browser, text: string) => by.post(`/gallery?share=share-${++count + 1000}`, text)
  async function shares(by: Browser, mark: string, text = projectText(mark)): Promise<string> {
    server.later(1 / 60)
    const { status, body } = await answerOf(by, text)
    expect(status).toBe(201)
    return (body as { id: string }).id
  }
  const pageFor = async (by: Browser, query = '') => (await by.get(`/gallery${query}`)).body as Page
  const titles = async (by: Browser, query = '') => (await pageFor(by, query)).items.map(({ title }) => title)
  const ofTeacher = async (query = '') =>
    (await teacher.get(`/classes/${classId}/gallery${query}`)).body as Page & { waiting: number }

  test('a pupil changes 30 hearts at once, then has to wait', async () => {
    const id = await shares(fox.browser, 'liked')
    server.holdClock()
    const give = (at: number) => owl.browser.put(`/gallery/${id}/heart`, { on: at % 2 === 0 })
    for (let at = 0; at < 30; at++) expect((await give(at)).status).toBe(200)
    expect(await give(30)).toMatchObject({ status: 429, body: { error: 'tooManyHearts', seconds: 2 } })
    expect((await pageFor(fox.browser)).items[0]!.hearts).toBe(0)
    server.later(0.05)
    expect((await give(30)).status).toBe(200)
  })

  test('what one shares the class sees, the newest first, with the name it has in the class', async () => {
    await shares(fox.browser, 'one')
    const id = await shares(owl.browser, 'two')
    const { items, total } = await pageFor(fox.browser)
    expect(total).toBe(2)
    expect(items.map(({ title, by, own }) => [title, by, own])).toEqual([
      ['Garden two', 'Eule', false],
      ['Garden one', 'Fuchs', true],
    ])
    expect(items[0]!.world.size).toEqual({ width: 200, height: 150 })
    const { body } = await fox.browser.get(`/gallery/${id}`)
    expect(body).toMatchObject({ title: 'Garden two', chain: [], project: { name: 'Garden two' } })
    await teacher.patch(`/classes/${classId}/pupils/${owl.id}`, { nickname: 'Uhu' })
    expect((await pageFor(fox.browser)).items[0]).toMatchObject({ by: 'Uhu' })
  })

  test('what is shared is a snapshot: no progress goes along, and the own project goes on without it', async () => {
    const project = JSON.parse(projectText('a')) as object
    const text = JSON.stringify({ ...project, progress: { starts: [0, 1, 2], hints: 2 } })
    const id = await shares(fox.browser, 'a', text)
    const { body } = await owl.browser.get(`/gallery/${id}`)
    expect((body as { project: object }).project).not.toHaveProperty('progress')
    expect(JSON.stringify(body)).not.toContain('hints')
  })

  test('sent twice, because its answer was lost, it is one', async () => {
    const [one, other] = [
      await fox.browser.post('/gallery?share=share-twice', projectText('a')),
      await fox.browser.post('/gallery?share=share-twice', projectText('a')),
    ]
    expect(other.body).toEqual(one.body)
    expect((await pageFor(fox.browser)).total).toBe(1)
    await owl.browser.post('/gallery?share=share-twice', projectText('b'))
    expect((await pageFor(fox.browser)).total).toBe(2)
  })

  test('one heart a pupil, none for the own; it can be taken back, and nobody sees whose it is', async () => {
    const id = await shares(fox.browser, 'a')
    const heart = (by: Browser, on: boolean) => by.put(`/gallery/${id}/heart`, { on })
    expect((await heart(owl.browser, true)).body).toEqual({ hearts: 1, mine: true })
    expect((await heart(owl.browser, true)).body).toEqual({ hearts: 1, mine: true })
    expect((await heart(fox.browser, true)).status).toBe(409)
    const seen = await fox.browser.get(`/gallery/${id}`)
    expect(seen.body).toMatchObject({ hearts: 1, mine: false })
    const looks = [seen, await teacher.get(`/classes/${classId}/gallery/${id}`)]
    for (const { body } of looks) {
      expect(JSON.stringify(body)).not.toContain(owl.id)
      expect(JSON.stringify(body)).not.toContain('Eule')
    }
    expect((await heart(owl.browser, false)).body).toEqual({ hearts: 0, mine: false })
    expect((await heart(owl.browser, false)).body).toEqual({ hearts: 0, mine: false })
  })

  test('most hearts first; mine are mine', async () => {
    const [one, two] = [await shares(fox.browser, 'one'), await shares(owl.browser, 'two')]
    await shares(owl.browser, 'three')
    await owl.browser.put(`/gallery/${one}/heart`, { on: true })
    expect(await titles(owl.browser, '?by=hearts')).toEqual(['Garden one', 'Garden three', 'Garden two'])
    expect(await titles(owl.browser, '?by=mine')).toEqual(['Garden three', 'Garden two'])
    expect(await titles(owl.browser, '?by=mine&from=1')).toEqual(['Garden two'])
    expect((await owl.browser.get('/gallery?by=hidden')).status).toBe(400)
    expect((await owl.browser.delete(`/gallery/${two}`)).status).toBe(204)
    expect((await owl.browser.delete(`/gallery/${one}`)).status).toBe(404)
    expect(await titles(fox.browser)).toEqual(['Garden three', 'Garden one'])
  })

  test('what the teacher hides only its child still sees, until it is restored', async () => {
    const id = await shares(fox.browser, 'a')
    const path = `/classes/${classId}/gallery/${id}`
    expect((await teacher.put(path, { hidden: true })).status).toBe(204)
    expect(await titles(owl.browser)).toEqual([])
    expect((await owl.browser.get(`/gallery/${id}`)).status).toBe(404)
    expect((await owl.browser.put(`/gallery/${id}/heart`, { on: true })).status).toBe(404)
    expect((await pageFor(fox.browser, '?by=mine')).items).toMatchObject([{ hidden: true }])
    expect(await ofTeacher()).toMatchObject({ total: 0 })
    expect(await ofTeacher('?by=hidden')).toMatchObject({ total: 1 })
    await teacher.put(path, { hidden: false })
    expect(await titles(owl.browser)).toEqual(['Garden a'])
    expect((await teacher.put(path, {})).status).toBe(400)
  })

  test('a project with a photo of its own waits for the yes of the teacher', async () => {
    const { body } = await answerOf(fox.browser, withPhoto('a'))
    const { id } = body as { id: string }
    expect(body).toMatchObject({ waiting: true })
    expect(await titles(owl.browser)).toEqual([])
    expect((await owl.browser.get(`/gallery/${id}`)).status).toBe(404)
    expect(await ofTeacher('?by=waiting')).toMatchObject({ waiting: 1, items: [{ photo: true }] })
    const seen = await teacher.get(`/classes/${classId}/gallery/${id}`)
    expect(seen.body).toMatchObject({ project: { assets: { ['b'.repeat(64)]: pixel } } })
    await teacher.put(`/classes/${classId}/gallery/${id}`, { allowed: true })
    expect(await titles(owl.browser)).toEqual(['Garden a'])
    expect((await owl.browser.get(`/gallery/${id}`)).body).toMatchObject({
      project: { assets: { ['b'.repeat(64)]: pixel } },
    })
  })

  test('who looks at the list hears at once that a heart came, and that something was hidden', async () => {
    const id = await shares(fox.browser, 'a')
    const stream = await fox.browser.events('/me/stream')
    await stream.next()
    await owl.browser.put(`/gallery/${id}/heart`, { on: true })
    expect(await stream.next()).toEqual({ event: 'gallery', data: {} })
    await teacher.put(`/classes/${classId}/gallery/${id}`, { hidden: true })
    expect(await stream.next()).toEqual({ event: 'gallery', data: {} })
  })

  test('switched off there is no gallery; what is shared is there again with it', async () => {
    const id = await shares(fox.browser, 'a')
    expect((await fox.browser.get('/me')).body).toMatchObject({ class: { gallery: true, asking: false } })
    await teacher.put(`/classes/${classId}/gallery`, { on: false })
    expect((await fox.browser.get('/me')).body).toMatchObject({ class: { gallery: false } })
    for (const path of ['/gallery', `/gallery/${id}`])
      expect(await owl.browser.get(path)).toMatchObject({ status: 403, body: { error: 'galleryOff' } })
    expect((await answerOf(owl.browser, projectText('b'))).status).toBe(403)
    expect(await ofTeacher()).toMatchObject({ on: false, total: 1 })
    await teacher.put(`/classes/${classId}/gallery`, { on: true })
    expect(await titles(owl.browser)).toEqual(['Garden a'])
  })

  test('nothing of another class is seen, listed, hidden or given a heart', async () => {
    const id = await shares(fox.browser, 'a')
    const other = await server.openClass(teacher, '6a')
    const stranger = await server.pupil(other.code, 'Fuchs')
    expect(await titles(stranger.browser)).toEqual([])
    expect((await stranger.browser.get(`/gallery/${id}`)).status).toBe(404)
    expect((await stranger.browser.put(`/gallery/${id}/heart`, { on: true })).status).toBe(404)
    expect((await stranger.browser.delete(`/gallery/${id}`)).status).toBe(404)
    for (const change of [{ hidden: true }, { allowed: true }])
      expect((await teacher.put(`/classes/${other.id}/gallery/${id}`, change)).status).toBe(404)
    expect((await teacher.get(`/classes/${other.id}/gallery/${id}`)).status).toBe(404)
  })

  test.each([
    ['no project', '{}', 422],
    ['no JSON', 'rally', 422],
    ['a key that reaches into objects', projectText('a').replace('{', '{"__proto__":{"a":1},'), 422],
    ['a program that is none', projectText('a').replace('"stacks":[]', '"stacks":7'), 422],
    [
      'a picture that is none',
      projectText('a', { ['c'.repeat(64)]: { type: 'text/html', base64: '' } }),
      422,
    ],
    ['no title', projectText('a').replace('Garden a', '\u202e \u200b'), 400],
    ['a title as long as a page', projectText('x'.repeat(61)), 400],
  ])('%s is refused, and nothing of it stays', async (_, text, status) => {
    expect((await answerOf(fox.browser, text)).status).toBe(status)
    expect(await pageFor(fox.browser, '?by=mine')).toEqual({ total: 0, items: [] })
  })

  test('a title is text: what would turn lines around goes, markup stays the letters that it is', async () => {
    await shares(fox.browser, '</script><b>\u202e"1')
    expect(await titles(owl.browser)).toEqual(['Garden </script><b> "1'])
  })

  test('what is shared counts with the class, pictures once, and goes with its child', async () => {
    const space = async () => ((await teacher.get(`/classes/${classId}`)).body as { space: number }).space
    const before = await space()
    const id = await shares(fox.browser, 'a', withPhoto('a'))
    const one = (await space()) - before
    await shares(owl.browser, 'b', withPhoto('b'))
    expect((await space()) - before).toBe(2 * one - pixel.base64.length)
    await fox.browser.delete(`/gallery/${id}`)
    expect((await space()) - before).toBe(one)
    await teacher.delete(`/classes/${classId}/pupils/${owl.id}`)
    expect(await space()).toBe(before)
    expect(await ofTeacher()).toMatchObject({ total: 0 })
    for (const table of ['shared', 'sharedAsset', 'heart'] as const)
      expect(
        JSON.stringify(await server.ports.database.db.selectFrom(table).selectAll().execute()),
      ).not.toContain(owl.id)
  })

  test('all about a pupil holds what it has shared and liked', async () => {
    await shares(fox.browser, 'a')
    const id = await shares(owl.browser, 'b')
    await fox.browser.put(`/gallery/${id}/heart`, { on: true })
    const { body } = await teacher.get(`/classes/${classId}/pupils/${fox.id}/everything`)
    expect(JSON.parse(body as string)).toMatchObject({ shared: [{ title: 'Garden a' }], hearts: [id] })
  })

  test('a pupil shares a hundred things, and no more until one is taken back', async () => {
    const ids = []
    for (let at = 0; at < 100; at++) ids.push(await shares(fox.browser, `${at}`))
    expect(await answerOf(fox.browser, projectText('more'))).toMatchObject({
      status: 409,
      body: { error: 'galleryFull' },
    })
    const { items, total } = await pageFor(owl.browser)
    expect([items.length, total]).toEqual([24, 100])
    const seen = new Set<string>()
    for (let from = 0; from < total; from += 24)
      for (const { id } of (await pageFor(owl.browser, `?from=${from}`)).items) seen.add(id)
    expect(seen.size).toBe(100)
    await fox.browser.delete(`/gallery/${ids[0]}`)
    await shares(fox.browser, 'again')
  })
})
