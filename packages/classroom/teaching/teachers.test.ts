import { sql } from 'kysely'
import { beforeAll, beforeEach, expect, test } from 'vitest'
import type { Db } from '../database/database.ts'
import type { Browser } from '../testing/browser.ts'
import { onBothDatabases } from '../testing/databases.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { carryOut } from './deleting-store.ts'

const [old, chosen] = ['ein anderer satz', 'kastanie im schnee']

/** Tables that have one of the texts in any column. */
async function tablesWith(db: Db, texts: readonly string[]): Promise<string[]> {
  const found = []
  for (const { name, schema } of await db.introspection.getTables()) {
    const table = schema === undefined ? sql.table(name) : sql.table(`${schema}.${name}`)
    const { rows } = await sql<object>`select * from ${table}`.execute(db)
    if (texts.some((text) => JSON.stringify(rows).toLowerCase().includes(text))) found.push(name)
  }
  return found.toSorted()
}

onBothDatabases((fresh) => {
  let server: Server
  let operator: Browser
  let count = 0

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    server.holdClock()
    operator = await server.firstTeacher('the.operator')
  })
  beforeEach(() => server.later(60))

  const furtherTeacher = async () => {
    const username = `teacher.${++count}`
    const browser = await server.furtherTeacher(operator, username)
    const { db } = server.ports.database
    const { id } = await db
      .selectFrom('teacher')
      .select('id')
      .where('username', '=', username)
      .executeTakeFirstOrThrow()
    return { browser, username, id }
  }
  const signIn = (username: string, password: string, browser = server.browser()) =>
    browser.post('/auth/sign-in/username', { username, password })
  const change = (browser: Browser, password: string, newPassword: string) =>
    browser.post('/teachers/me/password', { password, newPassword })

  test('a new password ends the other sessions of the teacher, and no others', async () => {
    const { browser, username } = await furtherTeacher()
    const laptop = server.browser()
    await signIn(username, old, laptop)
    expect((await change(browser, old, chosen)).status).toBe(204)
    expect((await browser.get('/classes')).status).toBe(200)
    expect((await laptop.get('/classes')).status).toBe(401)
    expect((await operator.get('/classes')).status).toBe(200)
    expect((await signIn(username, old)).status).toBe(401)
    expect((await signIn(username, chosen)).status).toBe(204)
  })

  test('streams of the ended sessions end, and that of the session that stays is opened again', async () => {
    const { browser, username } = await furtherTeacher()
    const { id } = await server.openClass(browser)
    const laptop = server.browser()
    await signIn(username, old, laptop)
    const streams = [
      await browser.events(`/classes/${id}/stream`),
      await laptop.events(`/classes/${id}/stream`),
    ]
    await change(browser, old, chosen)
    for (const stream of streams)
      expect(await stream.until(({ event }) => event === 'end')).toMatchObject({ data: { reason: 'again' } })
    const statuses = [browser, laptop].map(async (one) => (await one.open(`/classes/${id}/stream`)).status)
    expect(await Promise.all(statuses)).toEqual([200, 401])
  })

  test('without the current password neither the password nor the account is changed', async () => {
    const { browser, username } = await furtherTeacher()
    const refused = { status: 403, body: { error: 'passwordWrong' } }
    expect(await change(browser, 'kastanie im sand', chosen)).toMatchObject(refused)
    expect(await browser.delete('/teachers/me', { password: 'kastanie im sand' })).toMatchObject(refused)
    expect((await signIn(username, old)).status).toBe(204)
  })

  test('ten wrong passwords, in whichever place, slow the next one', async () => {
    const { browser } = await furtherTeacher()
    for (let tries = 0; tries < 5; tries++) {
      expect((await change(browser, `wrong ${tries}`, chosen)).status).toBe(403)
      expect((await browser.delete('/teachers/me', { password: `wrong ${tries}` })).status).toBe(403)
    }
    expect(await change(browser, old, chosen)).toMatchObject({ status: 429, body: { error: 'tooManyTries' } })
    server.later(1)
    expect((await change(browser, old, chosen)).status).toBe(204)
  })

  test('common passwords, and those of the username, the program and a class are refused', async () => {
    const { browser, username } = await furtherTeacher()
    await server.openClass(browser, 'Igelklasse')
    for (const [newPassword, error] of [
      ['passwort123', 'passwordCommon'],
      [`${username}.2026`, 'passwordOfNames'],
      ['botgarten2026', 'passwordOfNames'],
      ['igelklasse!', 'passwordOfNames'],
    ] as const)
      expect(await change(browser, old, newPassword)).toMatchObject({ status: 400, body: { error } })
    expect((await change(browser, old, 'zu kurz')).status).toBe(400)
    expect((await signIn(username, old)).status).toBe(204)
  })

  test('a common password makes no account, and the link still works', async () => {
    const { token } = (await operator.post('/invitations')).body as { token: string }
    const make = (password: string) =>
      server.browser().post('/teachers', { token, username: 'k.common', password })
    expect(await make('basketball')).toMatchObject({ status: 400, body: { error: 'passwordCommon' } })
    expect((await make('basketball im regen')).status).toBe(204)
  })

  test('an account that has a common password from before still works', async () => {
    const { username } = await furtherTeacher()
    await server.ports.accounts.reset({ username, password: 'basketball' })
    const browser = server.browser()
    expect((await signIn(username, 'basketball', browser)).status).toBe(204)
    expect((await change(browser, 'basketball', chosen)).status).toBe(204)
  })

  test('of a deleted account no table has the id or the username; the tombstone has the id', async () => {
    const { browser, username, id } = await furtherTeacher()
    const { db } = server.ports.database
    const made = await server.openClass(browser, '7c')
    await browser.put(`/classes/${made.id}/wifi`, { name: 'Aula', password: 'sonnenschein' })
    await browser.post(`/classes/${made.id}/substitute`)
    await server.pupil(made.code, 'Fuchs')
    expect(await tablesWith(db, [id.toLowerCase(), username])).toEqual([
      ...['account', 'class', 'teacher', 'teacherSession', 'wifi'],
    ])
    await browser.delete(`/classes/${made.id}`, { name: '7c' })
    expect((await browser.delete('/teachers/me', { password: old })).status).toBe(204)
    expect(await tablesWith(db, [id.toLowerCase(), username])).toEqual(['tombstone'])
    expect(await tablesWith(db, [username])).toEqual([])
    expect(server.buried.at(-1)).toEqual({ kind: 'teacher', id })
  })

  test('who deletes the account is signed out everywhere, and the device is no longer known to it', async () => {
    const { browser, username } = await furtherTeacher()
    const laptop = browser.twin()
    await browser.delete('/teachers/me', { password: old })
    expect([...browser.cookies.keys()]).toEqual([])
    expect((await laptop.get('/classes')).status).toBe(401)
    expect((await signIn(username, old)).status).toBe(401)
    // The name is free again.
    expect((await server.furtherTeacher(operator, username)).cookies.size).toBeGreaterThan(0)
  })

  test('while a teacher owns a class her account stays, and the refusal names the class', async () => {
    const { browser } = await furtherTeacher()
    for (const name of ['5b', '7c']) await server.openClass(browser, name)
    const before = server.buried.length
    const refused = { status: 409, body: { error: 'ownsClasses', classes: '5b, 7c' } }
    expect(await browser.delete('/teachers/me', { password: old })).toMatchObject(refused)
    expect((await browser.get('/classes')).status).toBe(200)
    expect(server.buried).toHaveLength(before)
  })

  test('the only operator cannot delete the own account', async () => {
    const gone = await operator.delete('/teachers/me', { password: 'kastanie im regen' })
    expect(gone).toMatchObject({ status: 409, body: { error: 'onlyOperator' } })
    expect((await operator.get('/classes')).status).toBe(200)
  })

  test('the operator sees all teachers with numbers of classes and pupils, and no name of a class', async () => {
    const { browser, username, id } = await furtherTeacher()
    const { code } = await server.openClass(browser, 'Geheimklasse')
    await server.openClass(browser, 'Andere')
    for (const nickname of ['Fuchs', 'Otter', 'Igel']) await server.pupil(code, nickname)
    const { body } = await operator.get('/teachers')
    const { teachers } = body as { teachers: { username: string }[] }
    expect(teachers.find((one) => one.username === username)).toEqual({
      ...{ id, username, operator: false, classes: 2, pupils: 3 },
    })
    expect(teachers.filter((one) => 'operator' in one && one.operator)).toMatchObject([
      { username: 'the.operator' },
    ])
    expect(JSON.stringify(body)).not.toContain('Geheimklasse')
  })

  test('the operator deletes a teacher with all classes, once the username is typed', async () => {
    const { browser, username, id } = await furtherTeacher()
    const made = await server.openClass(browser)
    const child = await server.pupil(made.code, 'Fuchs')
    const other = await server.openClass(operator)
    const remove = (typed: string) => operator.delete(`/teachers/${id}`, { username: typed })
    expect(await remove('teacher')).toMatchObject({ status: 400, body: { error: 'otherUsername' } })
    expect((await browser.get(`/classes/${made.id}`)).status).toBe(200)
    expect((await remove(username.toUpperCase())).status).toBe(204)
    expect((await browser.get('/classes')).status).toBe(401)
    expect((await child.browser.get('/me')).status).toBe(410)
    expect(server.buried.slice(-2)).toEqual([
      { kind: 'class', id: made.id },
      { kind: 'teacher', id },
    ])
    expect((await operator.get(`/classes/${other.id}`)).status).toBe(200)
    expect(await remove(username)).toMatchObject({ status: 404, body: { error: 'noSuchTeacher' } })
  })

  test('the operator deletes the own account only where the password is asked', async () => {
    const { teachers } = (await operator.get('/teachers')).body as {
      teachers: { id: string; operator: boolean }[]
    }
    const { id } = teachers.find((one) => one.operator)!
    expect(await operator.delete(`/teachers/${id}`, { username: 'the.operator' })).toMatchObject({
      ...{ status: 409, body: { error: 'ownAccount' } },
    })
  })

  test('a deleted teacher who came back with an older copy is deleted again, but never with a class', async () => {
    const { browser, id } = await furtherTeacher()
    const { db } = server.ports.database
    const again = () => db.transaction().execute((inside) => carryOut(inside, { kind: 'teacher', id }))
    const made = await server.openClass(browser)
    await again()
    expect((await browser.get(`/classes/${made.id}`)).status).toBe(200)
    await browser.delete(`/classes/${made.id}`, { name: '5b' })
    await again()
    await again()
    expect((await browser.get('/classes')).status).toBe(401)
  })

  test('the answer that everyone gets has no username of the operator', async () => {
    for (const browser of [server.browser(), (await furtherTeacher()).browser, operator]) {
      const { body } = await browser.get('/state')
      expect(body).toMatchObject({ firstTeacher: { name: null, madeAt: expect.any(Number) as number } })
    }
    const { body } = await server.browser().get('/state')
    expect(JSON.stringify(body)).not.toContain('the.operator')
  })
})
