import { endClasses, firstTeacherToken } from '@botgarten/classroom'
import { expect, test, vi } from 'vitest'
import { apiOn, freshServer } from '../testing/class-server.ts'
import { classes, made } from './answers.ts'
import { BackupPhrase } from './backup-phrase.svelte.ts'
import { ServerHealth } from './server-health.svelte.ts'

const findings = [
  { verdict: 'clock.fine', fine: true, facts: { now: '2026-11-24' } },
  { verdict: 'backup.none', fine: false, facts: {} },
  { verdict: 'folder.inUse', fine: true, facts: { path: '/data' } },
]

test('what needs somebody comes first; where the data lie and how much that is, is for who runs the server', async () => {
  const server = await freshServer()
  Object.assign(server.ports.host, { findings: () => findings })
  const operator = await server.firstTeacher()
  await server.openClass(operator)
  const { token } = (await operator.post('/invitations')).body as { token: string }

  const invited = apiOn(server)
  await invited.send('POST', '/teachers', { token, username: 'k.otto', password: 'ein anderer satz' })
  const theirs = new ServerHealth(invited)
  await theirs.look(false)
  expect(theirs.findings!.map(({ verdict }) => verdict)).toEqual(['backup.none', 'clock.fine'])
  expect(theirs.sizes).toBeNull()

  const running = apiOn(server)
  await running.send('POST', '/auth/sign-in/username', {
    username: 'm.weber',
    password: 'kastanie im regen',
  })
  const ours = new ServerHealth(running)
  await ours.look(true)
  expect(ours.findings!.at(-1)!.verdict).toBe('folder.inUse')
  expect(ours.sizes).toMatchObject({ classes: 1, pupils: 0 })
})

test('a copy is made by a press, and is then there', async () => {
  const server = await freshServer()
  let made = false
  Object.assign(server.ports.host, {
    backUp: () => Promise.resolve(void (made = true)),
    findings: () => [{ verdict: made ? 'backup.made' : 'backup.none', fine: made, facts: {} }],
  })
  const api = apiOn(server)

  const token = await firstTeacherToken(server.ports)
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const health = new ServerHealth(api)
  await health.look(true)
  expect(health.findings![0]!.verdict).toBe('backup.none')
  await health.backUp()
  expect(health.findings![0]!.verdict).toBe('backup.made')
  expect(health.refused).toBeNull()
})

test('the phrase of the backups is shown once for the asking, from then on for the right password', async () => {
  const server = await freshServer()
  const api = apiOn(server)
  const token = await firstTeacherToken(server.ports)
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const first = new BackupPhrase(api)
  await first.show(null)
  expect(first.words!.split('-')).toHaveLength(10)
  first.hide()
  expect(first.words).toBeNull()

  const later = new BackupPhrase(api)
  await later.show(null)
  expect([later.words, later.refused, later.needsPassword]).toEqual([null, 'passwordNeeded', true])
  await later.show('kastanie im schnee')
  expect([later.words, later.refused, later.needsPassword]).toEqual([null, 'passwordWrong', true])
  await later.show('kastanie im regen')
  expect(later.words!.split('-')).toHaveLength(10)
  expect(later.needsPassword).toBe(false)
})

test('the operator sees both dates of a clock that is doubted, and answers with one press', async () => {
  const server = await freshServer()
  const api = apiOn(server)
  const token = await firstTeacherToken(server.ports)
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const { id } = await api.ask(made, 'POST', '/classes', {
    ...{ name: '5b', language: 'en', grade: 5, endsOn: server.ports.day(3) },
  })
  await endClasses(server.ports)
  const last = server.ports.day(0)
  const health = new ServerHealth(api)
  await health.look(true)
  expect(health.clock).toBeNull()

  server.now += 8 * 86_400_000
  await health.look(true)
  const today = server.ports.day(0)
  expect(health.clock).toMatchObject({ today, last, ended: 1, denied: false })
  const doubted = { verdict: 'clock.doubted', fine: false, facts: { now: today, last } }
  expect(health.findings).toContainEqual(doubted)

  const own = async () => (await api.ask(classes, 'GET', '/classes')).classes
  expect(await own()).toMatchObject([{ id, hidden: true, words: [] }])
  await health.answer(false)
  expect(health.clock).toMatchObject({ denied: true })
  expect(await own()).toMatchObject([{ id, hidden: false }])
  await health.answer(true)
  expect(health.clock).toBeNull()
  expect(health.refused).toBeNull()
  expect(await own()).toEqual([])
})

test('a page that looks again and again looks at once', async () => {
  const server = await freshServer()
  const api = apiOn(server)
  const token = await firstTeacherToken(server.ports)
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const health = new ServerHealth(api)
  const stop = health.watch(true)
  await vi.waitFor(() => expect(health.findings).not.toBeNull())
  stop()
})
