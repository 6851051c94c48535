import { firstTeacherToken } from '@botgarten/classroom'
import type { Server } from '@botgarten/classroom/testing'
import { settle, StreamSource } from '@botgarten/classroom/testing/event-source'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { askerOn, freshServer } from '../testing/class-server.ts'
import { Account } from './account.svelte.ts'
import { made, substituteLink } from './answers.ts'
import { ClassApi } from './api.ts'
import { seenTile } from './live.ts'
import { LiveClass } from './live.svelte.ts'

let server: Server
let api: ClassApi
let live: LiveClass
let sources: StreamSource[]
let stop: () => void

function follow(id: string, ask: ReturnType<typeof askerOn>) {
  return new LiveClass(new ClassApi(ask), id, (path) => {
    const source = new StreamSource(ask(path, {}))
    sources.push(source)
    return source
  })
}

beforeEach(async () => {
  server = await freshServer()
  sources = []
  const ask = askerOn(server)
  api = new ClassApi(ask)
  const token = (await firstTeacherToken(server.ports))!
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: '2027-01-31' }
  live = follow((await api.ask(made, 'POST', '/classes', about)).id, ask)
  stop = live.watch()
  await vi.waitFor(() => expect(live.connection).toBe('open'))
})
afterEach(() => stop())

async function joined(nickname: string) {
  await live.open()
  await settle(server)
  const pupil = await server.pupil(live.school!.code, nickname)
  await settle(server)
  return pupil
}

const report = {
  ...{ card: 'friendship', project: 'project-1', checks: ['passed', 'open', 'open'], failed: 0 },
  ...{ running: true, idle: 0, size: [600, 400], pose: { x: 100, y: 100, heading: 0 }, trail: [90, 100] },
}
const nicknames = () => live.inOrder(server.now).map(({ nickname }) => nickname)

test('a pupil who joins appears, and what its page reports follows', async () => {
  expect(live.school).toMatchObject({ name: '5b', open: false })
  const fox = await joined('Fuchs')
  expect(live.tiles).toMatchObject([{ nickname: 'Fuchs', isNew: true, live: null }])
  await fox.browser.put('/me/here', report)
  await settle(server)
  expect(live.tiles[0]!.live).toMatchObject({ card: 'friendship', pose: { x: 100 } })
  expect(seenTile(live.tiles[0]!, server.now)).toMatchObject({ here: true, need: null })
})

test('joining stops while the lesson goes on', async () => {
  await live.open()
  await live.stopJoining()
  await settle(server)
  expect(live.school).toMatchObject({ open: true, joiningUntil: null })
  await live.close()
  await settle(server)
  expect(live.school).toMatchObject({ open: false })
})

test('a raised hand comes first and can be put down', async () => {
  await joined('Ananas')
  const zebra = await joined('Zebra')
  expect(nicknames()).toEqual(['Ananas', 'Zebra'])
  await zebra.browser.put('/me/hand', { up: true })
  await settle(server)
  expect(nicknames()).toEqual(['Zebra', 'Ananas'])
  await live.handDown(zebra.id)
  await settle(server)
  expect(nicknames()).toEqual(['Ananas', 'Zebra'])
})

const stateOf = async (pupil: Awaited<ReturnType<typeof joined>>) =>
  (await pupil.browser.get('/me')).body as {
    readonly attention: number | null
    readonly inside: { readonly by: string } | null
    readonly handouts: readonly object[]
  }

test('hints, programs and attention reach the child, and attention is taken back', async () => {
  const fox = await joined('Fuchs')
  await live.sendHint(fox.id, { card: 'friendship', hint: 2 })
  server.now += 1000
  await live.sendHint(null, { text: 'Look at the eyes.' })
  server.now += 1000
  await live.sendProgram(null, { card: 'fear' })
  await live.callAttention(true)
  await settle(server)
  const { attention, handouts } = await stateOf(fox)
  expect(attention).toBe(600)
  expect(handouts).toMatchObject([
    { kind: 'hint', card: 'friendship', hint: 2 },
    { kind: 'hint', text: 'Look at the eyes.' },
    { kind: 'program', card: 'fear' },
  ])
  expect(live.attention).toBe(true)
  await live.callAttention(false)
  await settle(server)
  expect(live.attention).toBe(false)
})

test('while a teacher looks inside the child sees by whom', async () => {
  const fox = await joined('Fuchs')
  expect(await live.look(fox.id, null)).toBeNull()
  expect((await stateOf(fox)).inside).toEqual({ by: 'm.weber' })
  await live.lookAway(fox.id)
  expect((await stateOf(fox)).inside).toBeNull()
})

test('which cards and blocks are free today is kept', async () => {
  await live.setFree(['friendship', 'fear'], 'plain')
  await settle(server)
  expect(live.school).toMatchObject({ cards: ['friendship', 'fear'], level: 'plain' })
})

test('a stream that breaks is shown as broken, and comes back with all that was missed', async () => {
  sources[0]!.cut()
  expect(live.connection).toBe('broken')
  // A browser opens it again by itself; here that is a new one.
  stop()
  await joined('Fuchs')
  expect(live.tiles).toEqual([])
  stop = live.watch()
  await vi.waitFor(() => expect(live.connection).toBe('open'))
  expect(nicknames()).toEqual(['Fuchs'])
})

test('a stream that the server ends to be opened again is opened again', async () => {
  server.later(11)
  server.ports.live.tick()
  await settle(server)
  await settle(server)
  expect(sources).toHaveLength(2)
  expect(live.connection).toBe('open')
})

test('when the class is deleted the page knows that it is over', async () => {
  await api.send('DELETE', `/classes/${live.id}`, { name: '5b' })
  await settle(server)
  expect(live.connection).toBe('ended')
})

test('a session that is over ends the stream on every device', async () => {
  await api.send('POST', '/teachers/me/end-sessions')
  await settle(server)
  expect(live.connection).toBe('ended')
})

test('a substitute sees the class and helps, and changes no name', async () => {
  const fox = await joined('Fuchs')
  const { token } = await api.ask(substituteLink, 'POST', `/classes/${live.id}/substitute`)
  const ask = askerOn(server)
  const account = new Account(new ClassApi(ask))
  expect(await account.substitute(token)).toBe(live.id)
  expect(account.access).toEqual({ kind: 'substitute', class: live.id, name: '5b' })
  const lent = follow(live.id, ask)
  const end = lent.watch()
  await vi.waitFor(() => expect(lent.connection).toBe('open'))
  expect(lent.tiles.map(({ nickname }) => nickname)).toEqual(['Fuchs'])
  expect(await lent.sendHint(fox.id, { text: 'Try it.' })).toBe(true)
  const rename = new ClassApi(ask).send('PATCH', `/classes/${live.id}/pupils/${fox.id}`, {
    nickname: 'Dachs',
  })
  await expect(rename).rejects.toMatchObject({ status: expect.any(Number) as number })
  end()
  await account.signOut(false)
  expect(account.access.kind).toBe('out')
})

test('times are seen by the server’s clock, not by that of this device', () => {
  // The state came a moment ago; a minute is far more than a slow machine takes for that.
  expect(Math.abs(live.at(Date.now()) - server.now)).toBeLessThan(60_000)
})

test.each([
  [401, 'ended'],
  [404, 'ended'],
  [410, 'ended'],
  [423, 'ended'],
  [405, 'broken'],
  [503, 'broken'],
])('a server that answers %s when a silent class is checked: the page is %s', async (status, connection) => {
  const refused = () => Promise.resolve(Response.json({ code: 'refused' }, { status }))
  const other = new LiveClass(new ClassApi(refused), live.id, () => new StreamSource(new Promise(() => {})))
  vi.stubGlobal('window', new EventTarget())
  const end = other.watch()
  window.dispatchEvent(new Event('online'))
  await vi.waitFor(() => expect(other.connection).toBe(connection))
  end()
  vi.unstubAllGlobals()
})
