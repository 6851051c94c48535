import { expect, test } from 'vitest'
import { everyNight } from './teaching/every-night.ts'
import { onBothDatabases } from './testing/databases.ts'
import { projectText } from './testing/projects.ts'
import { quickAccounts, Server } from './testing/world.ts'

onBothDatabases((fresh) => {
  test('a clock that begins in 1970 and then finds the time loses nothing: the pictures are asked', async () => {
    const database = await fresh()
    const server = new Server(database, quickAccounts(database))
    server.now = 60_000
    const teacher = await server.firstTeacher()
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Fuchs')
    const save = (base: number) =>
      child.browser.put(`/projects/project-1?base=${base}&save=save-000${base}`, projectText(`${base}`))
    expect((await save(0)).status).toBe(200)
    await everyNight(server.ports)

    server.now = Date.UTC(2026, 10, 24, 8)
    await everyNight(server.ports)
    // Whoever was here in 1970 may have gone: what is sent is saved, and nothing is read.
    expect((await save(1)).body).toMatchObject({ revision: 2 })
    const read = () => child.browser.get('/projects/project-1')
    expect(await read()).toMatchObject({ status: 401, body: { error: 'showPictures' } })
    await teacher.post(`/classes/${id}/open`)
    expect((await child.browser.post('/me/pictures', { pictures: child.pictures })).status).toBe(204)
    expect((await read()).body).toMatchObject({ revision: 2 })

    // A plug that is pulled takes the time along again.
    server.now = 120_000
    await everyNight(server.ports)
    expect((await save(2)).body).toMatchObject({ revision: 3 })
  })

  /** The class ends later than any clock here shows: a class that has ended is hidden. */
  const afterAll = '2028-12-31'
  const [hour, day, year] = [3_600_000, 86_400_000, 365 * 86_400_000]
  test.each([
    ['an hour', hour],
    ['a day', day],
    ['a year', year],
  ])(
    'a lesson that was closed while the clock was %s ahead locks no one out of the next one',
    async (_, ahead) => {
      const database = await fresh()
      const server = new Server(database, quickAccounts(database))
      const teacher = await server.firstTeacher()
      const { id, code } = await server.openClass(teacher)
      await teacher.patch(`/classes/${id}`, { endsOn: afterAll })
      const child = await server.pupil(code, 'Fuchs')
      server.now += ahead
      await teacher.post(`/classes/${id}/close`)
      server.now -= ahead
      expect((await teacher.post(`/classes/${id}/open`)).status).toBeLessThan(300)
      const read = async (who: typeof child) => (await who.browser.get('/projects')).status
      // The lesson is another one: the pupil shows the pictures once.
      expect(await read(child)).toBe(401)
      expect((await child.browser.post('/me/pictures', { pictures: child.pictures })).status).toBe(204)
      expect(await read(child)).toBe(200)
      expect(await read(await server.pupil(code, 'Eule'))).toBe(200)
    },
  )

  test.each([
    ['ahead', hour],
    ['ahead', day],
    ['ahead', year],
    ['back', -hour],
    ['back', -day],
    ['back', -year],
  ])('a clock that is set %s by %i ms in a lesson asks for the pictures at most once', async (_, change) => {
    const database = await fresh()
    const server = new Server(database, quickAccounts(database))
    const teacher = await server.firstTeacher()
    const { id, code } = await server.openClass(teacher)
    await teacher.patch(`/classes/${id}`, { endsOn: afterAll })
    const child = await server.pupil(code, 'Fuchs')
    server.now += change
    if ((await child.browser.get('/projects')).status === 401)
      expect((await child.browser.post('/me/pictures', { pictures: child.pictures })).status).toBe(204)
    expect((await child.browser.get('/projects')).status).toBe(200)
    server.now -= change
    if ((await child.browser.get('/projects')).status === 401)
      expect((await child.browser.post('/me/pictures', { pictures: child.pictures })).status).toBe(204)
    expect((await child.browser.get('/projects')).status).toBe(200)
  })
})
