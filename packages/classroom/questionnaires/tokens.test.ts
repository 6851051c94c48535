import { sql } from 'kysely'
import { answerIdOf, blindInput, evaluateBlinded, newFormKey, tokenOf } from '@botgarten/answers/tokens'
import { beforeAll, describe, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { Limits } from '../limits.ts'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { answerOf } from './testing/children.ts'
import { askedOn, permitOf, type Permit } from './testing/devices.ts'

const random = (bytes: number) => crypto.getRandomValues(new Uint8Array(bytes))

onBothDatabases((fresh) => {
  let database: Database
  /** Three nodes on one database. */
  let nodes: readonly [Server, Server, Server]
  let teacher: Browser
  let teacherThere: Browser

  beforeAll(async () => {
    database = await fresh()
    const node = () => new Server(database, quickAccounts(database))
    nodes = [node(), node(), node()]
    teacher = await nodes[0].firstTeacher()
    teacherThere = teacher.twin()
  })

  /** A class with an open form and `count` pupils. */
  async function asked(form = 'after', count = 1) {
    const { id, code } = await nodes[0].openClass(teacher)
    const at = `/classes/${id}/questionnaires`
    await teacher.post(at, { form })
    const pupils = []
    for (let n = 0; n < count; n += 1) pupils.push(await nodes[0].pupil(code, `Kind ${n}`))
    return { id, code, at, pupils, child: pupils[0]!.browser }
  }
  const send = (permit: Partial<Permit>, n = 1, node: Server = nodes[0]) =>
    node.browser(`192.168.1.${n}`).post('/answers', { ...permit, ...answerOf('after', n) })
  const answersTo = async (key: string) =>
    (await database.answers.db.selectFrom('answer').select('id').where('asking', '=', key).execute()).length

  test('one child with the key of the form cannot fill it: 0 of 293 further answers are accepted', async () => {
    const { child } = await asked()
    const permit = await permitOf(child)
    expect((await send(permit)).status).toBe(204)
    const further = Array.from({ length: 293 }, (_, n) => n.toString(16).padStart(32, '0'))
    for (const [n, id] of further.entries())
      expect((await send(n % 2 ? { ...permit, id } : { key: permit.key, id }, n)).status).toBe(422)
    expect(await answersTo(permit.key)).toBe(1)
  })

  test('an address that sends 200 answers at once is slowed down, and another one is not', async () => {
    const still = new Server(database, { ...quickAccounts(database), limits: new Limits(() => 0) })
    const { child } = await asked()
    const { key } = await permitOf(child)
    const statusOf = async (n: number) => (await send({ key, id: 'a'.repeat(32) }, n, still)).status
    const statuses = await Promise.all(Array.from({ length: 200 }, () => statusOf(1)))
    // 300 requests at once, and each of these counts as three.
    expect(statuses.filter((status) => status === 422)).toHaveLength(100)
    expect(statuses.filter((status) => status === 429)).toHaveLength(100)
    expect(await statusOf(2)).toBe(422)
  })

  test('a token that was made without the key of the form, or with another key, is refused', async () => {
    const { child } = await asked()
    const permit = await permitOf(child)
    const own = newFormKey(random)
    const made = blindInput()
    const token = tokenOf(made, evaluateBlinded(own, made.blinded, random), own.publicKey)
    const forged = { key: permit.key, id: answerIdOf(token), token }
    expect(await send(forged)).toMatchObject({ status: 422, body: { error: 'tokenRefused' } })
    const input = 'a'.repeat(64)
    expect(await send({ ...permit, token: { ...permit.token, input } })).toMatchObject({ status: 422 })
    const other = await permitOf((await asked()).child)
    expect(await send({ ...other, key: permit.key })).toMatchObject({ status: 422 })
    expect(await answersTo(permit.key)).toBe(0)
  })

  test('a pupil gets one token a form: again for the same blinded input, and for no other', async () => {
    const { child } = await asked()
    const made = blindInput()
    const first = await permitOf(child, made)
    expect(await permitOf(child, made)).toEqual(first)
    const { key } = first
    const second = { key, blinded: blindInput().blinded }
    expect(await child.post('/me/questionnaire/token', second)).toMatchObject({
      ...{ status: 409, body: { error: 'tokenGiven' } },
    })
    expect((await child.post('/me/questionnaire/token', { key, blinded: '0'.repeat(64) })).status).toBe(400)
    const other = { key: 'f'.repeat(32), blinded: made.blinded }
    expect((await child.post('/me/questionnaire/token', other)).body).toEqual({ error: 'noSuchForm' })
  })

  test('a pupil who sends three inputs to three nodes at once gets one token', async () => {
    const { child } = await asked()
    const { key } = await askedOn(child)
    const cookies = [...child.cookies]
    const answers = await Promise.all(
      nodes.map((node) => {
        const browser = node.browser()
        for (const [name, value] of cookies) browser.cookies.set(name, value)
        return browser.post('/me/questionnaire/token', { key, blinded: blindInput().blinded })
      }),
    )
    expect(answers.map(({ status }) => status).toSorted()).toEqual([200, 409, 409])
  })

  test('a token that is spent at three nodes at once is one answer', async () => {
    const { child } = await asked()
    const permit = await permitOf(child)
    const answers = await Promise.all(nodes.map((node, n) => send(permit, n, node)))
    expect(answers.map(({ status }) => status).toSorted()).toEqual([204, 422, 422])
    expect(await answersTo(permit.key)).toBe(1)
    const taken = answers.findIndex(({ status }) => status === 204)
    expect((await send(permit, taken)).status).toBe(204)
    expect((await send(permit, taken + 1)).body).toEqual({ error: 'tokenSpent' })
  })

  test('the key of a form is the same for every device, and a device gets it without saying who it is', async () => {
    const { id, pupils, child } = await asked('after', 2)
    const [one, other] = await Promise.all(pupils.map(({ browser }) => askedOn(browser)))
    expect(one!.publicKey).toBe(other!.publicKey)
    const stranger = nodes[2].browser()
    const { body, headers } = await stranger.get(`/answers/key?class=${id}`)
    expect(body).toEqual({ key: one!.key, publicKey: one!.publicKey })
    expect(headers.getSetCookie()).toEqual([])
    expect((await child.get(`/answers/key?class=${id}`)).body).toEqual({ error: 'withCookie' })
    await teacher.post(`/classes/${id}/questionnaires/after/close`)
    expect((await stranger.get(`/answers/key?class=${id}`)).status).toBe(404)
  })

  test('the teacher allows a pupil whose device has lost the token another one, once', async () => {
    const { at, child, pupils } = await asked()
    const again = () => teacherThere.post(`${at}/after/again`, { pupil: pupils[0]!.id })
    // Nothing is lost yet.
    expect((await again()).status).toBe(204)
    await permitOf(child)
    expect((await again()).status).toBe(204)
    const permit = await permitOf(child)
    expect((await send(permit)).status).toBe(204)
    expect(await again()).toMatchObject({ status: 409, body: { error: 'onceAgainOnly' } })
    await expect(permitOf(child)).rejects.toThrow('tokenGiven')
    const stranger = (await asked()).pupils[0]!.id
    expect((await teacher.post(`${at}/after/again`, { pupil: stranger })).status).toBe(404)
    expect((await teacher.post(`${at}/before/again`, { pupil: stranger })).status).toBe(404)
  })

  test('a code that was chosen at one node is taken at all of them', async () => {
    const { pupils } = await asked('before', 3)
    const [one, other, third] = await Promise.all(pupils.map(({ browser }) => permitOf(browser)))
    const choose = async (permit: Permit, node: Server) =>
      (await node.browser().post('/answers/code', { ...permit, code: 'owl-200' })).body
    expect(await choose(one!, nodes[0])).toEqual({ taken: false })
    expect(await choose(other!, nodes[0])).toEqual({ taken: true })
    expect(await choose(third!, nodes[1])).toEqual({ taken: true })
    expect(await choose(one!, nodes[2])).toEqual({ taken: false })
  })

  test('a code that three children choose at three nodes at once is taken for two of them', async () => {
    const { pupils } = await asked('before', 3)
    const permits = await Promise.all(pupils.map(({ browser }) => permitOf(browser)))
    const answers = await Promise.all(
      permits.map((permit, n) => nodes[n]!.browser().post('/answers/code', { ...permit, code: 'jay-300' })),
    )
    expect(answers.filter(({ body }) => (body as { taken: boolean }).taken)).toHaveLength(2)
  })

  test('a code is not chosen without a token, so that one child cannot take them all', async () => {
    const { child } = await asked('before')
    const permit = await permitOf(child)
    const choose = (more: object) =>
      nodes[0].browser().post('/answers/code', { ...permit, code: 'owl-200', ...more })
    expect((await choose({ token: undefined })).body).toEqual({ error: 'tokenMissing' })
    expect((await choose({ id: 'a'.repeat(32) })).body).toEqual({ error: 'tokenRefused' })
    for (let number = 100; number < 110; number += 1)
      expect((await choose({ code: `owl-${number}` })).body).toEqual({ taken: false })
    const rows = await database.answers.db
      .selectFrom('code')
      .selectAll()
      .where('asking', '=', permit.key)
      .execute()
    expect(rows).toHaveLength(1)
  })

  test('rows of codes hold hashes alone, in random order, and are deleted when the form has closed', async () => {
    const { at, pupils } = await asked('before', 6)
    const permits = await Promise.all(pupils.map(({ browser }) => permitOf(browser)))
    const { key } = permits[0]!
    for (const [n, permit] of permits.entries())
      await nodes[0].browser().post('/answers/code', { ...permit, code: `owl-${200 + n}` })
    const rowsOf = () =>
      database.answers.db.selectFrom('code').selectAll().where('asking', '=', key).execute()
    const rows = await rowsOf()
    expect(rows).toHaveLength(6)
    for (const row of rows) {
      expect(Object.keys(row).toSorted()).toEqual(['asking', 'code', 'owner'])
      expect([row.code, row.owner].join(' ')).toMatch(/^[0-9a-f]{64} [0-9a-f]{64}$/)
    }
    const text = JSON.stringify(rows)
    for (const { id } of permits) expect(text).not.toContain(id)
    if (database.kind === 'postgres') {
      const { rows: transactions } = await sql<{ xmin: string }>`
        select distinct xmin::text from code where asking = ${key}`.execute(database.answers.db)
      expect(transactions).toHaveLength(1)
    }
    await teacher.post(`${at}/before/close`)
    for (const node of nodes) node.later(2)
    await teacher.get(at)
    expect(await rowsOf()).toEqual([])
  })

  describe('a form that was opened before there were tokens', () => {
    const strip = (key: string) =>
      database.answers.db
        .updateTable('asking')
        .set({ secretKey: null, publicKey: null })
        .where('key', '=', key)
        .execute()
    const id = (n: number) => n.toString(16).padStart(32, '0')

    test('takes answers without one until it is closed, and needs one when it is opened again', async () => {
      const { at, child } = await asked()
      const { key } = await askedOn(child)
      await strip(key)
      expect((await child.get('/me/questionnaire')).body).toMatchObject({ key, publicKey: null })
      expect((await send({ key, id: id(1) })).status).toBe(204)
      await teacher.post(at, { form: 'after' })
      expect((await send({ key, id: id(2) }, 2)).status).toBe(204)
      await teacher.post(`${at}/after/close`)
      for (const node of nodes) node.later(2)
      await teacher.get(at)
      await teacher.post(at, { form: 'after' })
      expect((await send({ key, id: id(3) }, 3)).body).toEqual({ error: 'tokenMissing' })
      expect((await send(await permitOf(child), 4)).status).toBe(204)
    })
  })

  test('a page of an earlier version is not shown a form whose answers it could not send', async () => {
    const { child } = await asked()
    expect(await child.get('/me/questionnaire')).toMatchObject({ status: 409, body: { error: 'oldPage' } })
  })

  test('everything about a pupil includes the forms that the pupil has opened, and no answer', async () => {
    const { id, at, child, pupils } = await asked()
    const permit = await permitOf(child)
    await send(permit)
    await teacher.post(`${at}/after/close`)
    await teacher.post(at, { form: 'before' })
    await permitOf(child)
    const { body } = await teacher.get(`/classes/${id}/pupils/${pupils[0]!.id}/everything`)
    expect(JSON.parse(body as string)).toMatchObject({ questionnaires: ['after', 'before'] })
    for (const trace of [permit.id, permit.token.input, permit.key]) expect(body).not.toContain(trace)
  })

  test('with the class go the keys of its forms and the list of pupils who had a token', async () => {
    const { id, child, pupils } = await asked()
    const { key } = await permitOf(child)
    await teacher.delete(`/classes/${id}`, { name: '5b' })
    const rows = [
      ...(await database.answers.db.selectFrom('asking').select('key').where('key', '=', key).execute()),
      ...(await database.db.selectFrom('token').selectAll().where('pupil', '=', pupils[0]!.id).execute()),
    ]
    expect(rows).toEqual([])
  })
})
