import { beforeAll, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import type { Browser } from '../testing/browser.ts'

const wrongOf = (three: readonly string[]) => [three[1], three[0], three[2]]

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser

  beforeAll(async () => {
    server = new Server(await fresh())
    teacher = await server.firstTeacher()
  })

  test('a child joins with the code and a nickname and is given three pictures', async () => {
    const { code } = await server.openClass(teacher)
    const child = server.browser()
    expect((await child.post('/look', { code })).body).toEqual({ name: '5b', language: 'en', grade: 5 })
    const joined = await child.post('/join', { code, nickname: ' Fuchs  7 ' })
    expect(joined.status).toBe(201)
    expect(joined.body).toMatchObject({ nickname: 'Fuchs 7' })
    const me = await child.get('/me')
    expect(me.body).toMatchObject({ nickname: 'Fuchs 7', fresh: true, hand: false })
    expect(me.body).toMatchObject({ class: { name: '5b', open: true } })
  })

  test('a nickname is one child of a class, however it is written', async () => {
    const [{ code }, other] = [await server.openClass(teacher), await server.openClass(teacher, '6a')]
    await server.pupil(code, 'Strauß')
    const again = await server.browser().post('/join', { code, nickname: 'STRAUSS' })
    expect(again).toMatchObject({ status: 409, body: { error: 'nicknameTaken' } })
    const elsewhere = await server.browser().post('/join', { code: other.code, nickname: 'Strauß' })
    expect(elsewhere.status).toBe(201)
  })

  test('of children who take the same nickname at once one gets it', async () => {
    const { code } = await server.openClass(teacher)
    const all = await Promise.all(
      Array.from({ length: 5 }, () => server.browser().post('/join', { code, nickname: 'Luna' })),
    )
    expect(all.map(({ status }) => status).toSorted()).toEqual([201, 409, 409, 409, 409])
  })

  test('forty devices behind one address join at once: each is in, with pictures of its own', async () => {
    const { id, code } = await server.openClass(teacher)
    const all = await Promise.all(
      Array.from({ length: 40 }, async (_, at) => {
        const browser = server.browser('192.168.0.1')
        await browser.post('/look', { code })
        return { browser, joined: await browser.post('/join', { code, nickname: `Kind ${at}` }) }
      }),
    )
    expect(all.map(({ joined }) => joined.status)).toEqual(Array.from({ length: 40 }, () => 201))
    const { body } = await teacher.get(`/classes/${id}/pupils`)
    expect(
      new Set((body as { pupils: { nickname: string }[] }).pupils.map(({ nickname }) => nickname)).size,
    ).toBe(40)
    for (const [at, { browser }] of all.entries())
      expect((await browser.get('/me')).body).toMatchObject({ nickname: `Kind ${at}` })
  })

  test('the three pictures in their order open the same work on another device', async () => {
    const { code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Otter')
    const tablet = server.browser()
    const back = await tablet.post('/return', { code, nickname: 'otter', pictures: child.pictures })
    expect(back).toMatchObject({ status: 200, body: { id: child.id, nickname: 'Otter' } })
    expect((await tablet.get('/me')).body).toMatchObject({ nickname: 'Otter' })
  })

  test('wrong pictures and a nickname that nobody has are answered alike', async () => {
    const { code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Igel')
    const shown = { code, pictures: wrongOf(child.pictures) }
    const wrong = await server.browser('10.1.1.1').post('/return', { ...shown, nickname: 'Igel' })
    const nobody = await server.browser('10.1.1.1').post('/return', { ...shown, nickname: 'Niemand' })
    expect(wrong).toMatchObject({ status: 403, body: { error: 'wrongPictures' } })
    expect([nobody.status, nobody.body]).toEqual([wrong.status, wrong.body])
  })

  test('a device makes ten new pupils in ten minutes at most', async () => {
    const { code } = await server.openClass(teacher)
    const device = server.browser('10.1.2.1')
    await server.pupil(code, 'Fuchs')
    expect(device.cookies.size).toBe(0)
    for (let count = 0; count < 10; count++) {
      // A nickname that another one has makes no pupil.
      expect((await device.post('/join', { code, nickname: 'Fuchs' })).status).toBe(409)
      expect((await device.post('/join', { code, nickname: `Igel ${count}` })).status).toBe(201)
    }
    expect(await device.post('/join', { code, nickname: 'Igel' })).toMatchObject({
      ...{ status: 429, body: { error: 'tooManyTries', seconds: 600 } },
    })
    server.later(11)
    expect((await device.post('/join', { code, nickname: 'Igel' })).status).toBe(201)
  })

  test('20 changes of a raised hand pass at once, then the pupil has to wait; other requests of the pupil pass', async () => {
    const { code } = await server.openClass(teacher)
    const { browser } = await server.pupil(code, 'Fuchs')
    server.holdClock()
    const move = (at: number) => browser.put('/me/hand', { up: at % 2 === 0 })
    for (let at = 0; at < 20; at++) expect((await move(at)).status).toBe(204)
    expect(await move(20)).toMatchObject({ status: 429, body: { error: 'tooManyHands', seconds: 2 } })
    expect((await browser.get('/me')).body).toMatchObject({ hand: false })
    server.later(0.05)
    expect((await move(20)).status).toBe(204)
    expect((await browser.get('/me')).body).toMatchObject({ hand: true })
  })

  test('a class has 100 pupils at most, and is as it was for those who are in', async () => {
    const { id, code } = await server.openClass(teacher)
    const first = await server.pupil(code, 'Fuchs')
    for (let count = 1; count < 100; count++) await server.pupil(code, `Kind ${count}`)
    const late = server.browser()
    expect(await late.post('/join', { code, nickname: 'Eule' })).toMatchObject({
      ...{ status: 409, body: { error: 'classHasAll' } },
    })
    expect((await first.browser.get('/projects')).status).toBe(200)
    await teacher.delete(`/classes/${id}/pupils/${first.id}`)
    expect((await late.post('/join', { code, nickname: 'Eule' })).status).toBe(201)
  })

  test('a closed class, a code that never was and one that is none are answered alike', async () => {
    const { id, code } = await server.openClass(teacher)
    await teacher.post(`/classes/${id}/close`)
    const answers = []
    for (const text of [code, 'acorn-badg-cact-dove', 'acorn-badg-cact', 'x']) {
      const { status, body } = await server.browser('10.2.0.1').post('/look', { code: text })
      answers.push({ status, body })
    }
    expect(answers).toEqual(Array(4).fill({ status: 404, body: { error: 'noOpenClass' } }))
  })

  test('joining is open for twenty minutes', async () => {
    const { id, code } = await server.openClass(teacher)
    server.later(19)
    expect((await server.browser().post('/look', { code })).status).toBe(200)
    server.later(2)
    expect((await server.browser().post('/look', { code })).status).toBe(404)
    await teacher.post(`/classes/${id}/open`)
    expect((await server.browser().post('/look', { code })).status).toBe(200)
  })

  test('a teacher stops joining, and who is in stays in', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Fuchs')
    await teacher.post(`/classes/${id}/stop-joining`)
    expect((await server.browser().post('/look', { code })).status).toBe(404)
    expect((await child.browser.get('/projects')).status).toBe(200)
  })

  test('after 90 minutes, and once the class was closed, the pictures are asked', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Hase')
    server.later(89)
    expect((await child.browser.get('/me')).body).toMatchObject({ fresh: true })
    server.later(1)
    expect((await child.browser.get('/me')).body).toMatchObject({ fresh: false })
    expect(await child.browser.get('/projects')).toMatchObject({
      status: 401,
      body: { error: 'showPictures' },
    })
    const wrong = await child.browser.post('/me/pictures', { pictures: wrongOf(child.pictures) })
    expect(wrong.status).toBe(403)
    await child.browser.post('/me/pictures', { pictures: child.pictures })
    expect((await child.browser.get('/projects')).status).toBe(200)
    await teacher.post(`/classes/${id}/close`)
    expect((await child.browser.get('/projects')).status).toBe(401)
  })

  test('new pictures sign the other devices out, and the old ones open nothing', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Biene')
    const { body } = await teacher.post(`/classes/${id}/pupils/${child.id}/pictures`)
    const { pictures: renewed } = body as { pictures: string[] }
    expect((await child.browser.get('/me')).status).toBe(401)
    const shown = (three: readonly string[]) =>
      server.browser('10.5.0.1').post('/return', { code, nickname: 'Biene', pictures: three })
    expect((await shown(renewed)).status).toBe(200)
    if (renewed.join() !== child.pictures.join()) expect((await shown(child.pictures)).status).toBe(403)
  })

  test('a teacher signs a whole class out: each device needs the code and the pictures again', async () => {
    const { id, code } = await server.openClass(teacher)
    const other = await server.openClass(teacher, '6a')
    const [fox, owl] = [await server.pupil(code, 'Fuchs'), await server.pupil(other.code, 'Eule')]
    expect((await teacher.post(`/classes/${id}/sign-out-all`)).status).toBe(204)
    expect((await fox.browser.get('/me')).status).toBe(401)
    expect((await owl.browser.get('/me')).status).toBe(200)
    const back = await fox.browser.post('/return', { code, nickname: 'Fuchs', pictures: fox.pictures })
    expect(back.status).toBe(200)
  })

  test('a raised hand is seen, and goes down by the child, the teacher and the end of the lesson', async () => {
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Specht')
    const seen = async () =>
      ((await teacher.get(`/classes/${id}/pupils`)).body as { pupils: { handAt: number | null }[] })
        .pupils[0]!.handAt
    for (const down of [
      () => child.browser.put('/me/hand', { up: false }),
      () => teacher.post(`/classes/${id}/pupils/${child.id}/hand-down`),
      () => teacher.post(`/classes/${id}/close`),
    ]) {
      await child.browser.put('/me/hand', { up: true })
      expect(await seen()).toBe(server.now)
      await down()
      expect(await seen()).toBeNull()
    }
  })

  test('who leaves a device is forgotten there', async () => {
    const { code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Katze')
    const copied = child.browser.twin()
    await child.browser.post('/me/leave')
    expect((await child.browser.get('/me')).status).toBe(401)
    expect((await copied.get('/me')).status).toBe(401)
  })

  test('the database holds no pictures and no address', async () => {
    const { code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Adler')
    await server.browser('203.0.113.77').post('/look', { code: 'no such code' })
    const { db } = server.ports.database
    const all = []
    for (const table of ['pupil', 'attempt', 'teacherSession', 'rateLimit', 'pupilSession'])
      all.push(
        await db
          .selectFrom(table as 'pupil')
          .selectAll()
          .execute(),
      )
    const text = JSON.stringify(all.flat().map((row) => Object.values(row)))
    expect(text).not.toContain('203.0.113')
    expect(text).not.toContain('192.168')
    for (const picture of child.pictures) expect(text).not.toContain(`"${picture}"`)
    expect(text).not.toContain(child.browser.cookies.get('botgarten-pupil'))
  })

  test('a newcomer is marked as new until the lesson ends; one tap removes it with what it made', async () => {
    const { id, code } = await server.openClass(teacher)
    const pupil = await server.pupil(code, 'Stinktier')
    await pupil.browser.put('/projects/project-1?base=0&save=save-0001', projectText('rude'))
    const marks = async () => {
      const { pupils } = (await teacher.get(`/classes/${id}/pupils`)).body as { pupils: { isNew: number }[] }
      return pupils.map(({ isNew }) => isNew)
    }
    server.later(45)
    expect(await marks()).toEqual([1])
    await teacher.post(`/classes/${id}/close`)
    expect(await marks()).toEqual([0])
    expect((await teacher.delete(`/classes/${id}/pupils/${pupil.id}`)).status).toBe(204)
    expect(await marks()).toEqual([])
    expect((await teacher.get(`/classes/${id}`)).body).toMatchObject({ projects: 0, versions: 0 })
    expect((await pupil.browser.get('/projects')).status).toBe(401)
  })
})
