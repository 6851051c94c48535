import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import { evaluateBlinded, newFormKey } from '@botgarten/answers/tokens'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { forgetToken } from '#storage/answer-tokens.ts'
import { askedNow, isTakenInClass, type ClassQuestion } from './class-question.ts'
import { permitFor, type Permit } from './class-token.ts'

type Pupil = Awaited<ReturnType<Server['pupil']>>
type Body = Record<string, unknown>

let server: Server
let teacher: Awaited<ReturnType<Server['firstTeacher']>>
let school: { readonly id: string; readonly code: string }
let child: Pupil
let stored: Map<string, string>
/** Changes the answers of the class by path, as a class that wants to mark a child would. */
let forged: { [path: string]: (body: Body) => unknown }

/** A page's requests, which carry the child's cookies unless they are left out. */
async function fetched(path: string, { method = 'GET', credentials, body }: RequestInit = {}) {
  const sender = credentials === 'omit' ? server.browser() : child.browser
  const [place] = path.replace('/api/class', '').split('?')
  const answer = await sender.ask(method, path.replace('/api/class', ''), body)
  const given = forged[place!]?.(answer.body as Body) ?? answer.body
  return new Response(JSON.stringify(given), { status: answer.status })
}

beforeEach(async () => {
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database, quickAccounts(database))
  teacher = await server.firstTeacher()
  school = await server.openClass(teacher)
  child = await server.pupil(school.code, 'Fuchs')
  stored = new Map()
  forged = {}
  vi.stubGlobal('fetch', fetched)
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, text: string) => void stored.set(key, text),
    removeItem: (key: string) => void stored.delete(key),
  })
  await teacher.post(`/classes/${school.id}/questionnaires`, { form: 'before' })
})
afterEach(() => vi.unstubAllGlobals())

const asked = async () => (await askedNow(child.id)) as ClassQuestion
const permit = async () =>
  permitFor({ pupil: child.id, class: school.id, nickname: 'Fuchs', className: '5b' }, await asked())
const send = async (own: Permit, code: string | null = null) =>
  server.browser().post('/answers', { key: (await asked()).key, ...own, code, values: {} })

test('a page gets a token with which the class takes one answer', async () => {
  const own = (await permit()) as Permit
  expect((await send(own)).status).toBe(204)
  expect((await send(own, 'owl-200')).body).toEqual({ error: 'tokenSpent' })
})

test('a page that is loaded again gets the same token', async () => {
  const own = await permit()
  expect(await permit()).toEqual(own)
})

test('on another device the pupil is sent back to the first one', async () => {
  await permit()
  stored.clear()
  expect(await permit()).toBe('given')
})

test('once the pupil has answered, nothing on the device leads to the answer', async () => {
  const own = (await permit()) as Permit
  const { key } = await asked()
  expect([...stored.values()].join()).toContain(own.token!.input)
  forgetToken(child.id, key)
  expect(stored.size).toBe(0)
})

test('pupils who share a laptop have a token each', async () => {
  const first = await permit()
  const fox = child
  child = await server.pupil(school.code, 'Otter')
  const second = await permit()
  expect(second).not.toEqual(first)
  child = fox
  expect(await permit()).toEqual(first)
})

test('a key that the class gives one child alone is found out before anything is sent', async () => {
  const { publicKey } = newFormKey((bytes) => new Uint8Array(bytes).fill(3))
  forged['/me/questionnaire'] = (body) => ({ ...body, publicKey })
  expect(await permit()).toBe('marked')
  forged = { '/me/questionnaire': (body) => ({ ...body, key: 'a'.repeat(32) }) }
  expect(await permit()).toBe('marked')
  expect(stored.size).toBe(0)
})

test('a token that was made with another key than the shared one is refused by its proof', async () => {
  const random = (bytes: number) => crypto.getRandomValues(new Uint8Array(bytes))
  const own = newFormKey(random)
  forged['/me/questionnaire/token'] = () => {
    const [{ made }] = JSON.parse(stored.get('botgarten.answerTokens')!) as [{ made: { blinded: string } }]
    return evaluateBlinded(own, made.blinded, random)
  }
  expect(await permit()).toBe('marked')
})

test('a form that was opened before there were tokens is answered without one', async () => {
  await server.ports.database.answers.db
    .updateTable('asking')
    .set({ secretKey: null, publicKey: null })
    .execute()
  const own = (await permit()) as Permit
  expect(Object.keys(own)).toEqual(['id'])
  expect((await send(own)).status).toBe(204)
})

test('a class that cannot be reached gives no token, and the page says so', async () => {
  const question = await asked()
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')))
  const account = { pupil: child.id, class: school.id, nickname: 'Fuchs', className: '5b' }
  expect(await permitFor(account, question)).toBe('away')
})

test('a code is chosen with the token', async () => {
  const own = (await permit()) as Permit
  const { key } = await asked()
  child = await server.pupil(school.code, 'Otter')
  const other = (await permit()) as Permit
  expect(await isTakenInClass(key, own, 'owl-200')).toBe(false)
  expect(await isTakenInClass(key, other, 'owl-200')).toBe(true)
})
