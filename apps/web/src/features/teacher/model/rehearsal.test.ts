import { firstTeacherToken } from '@botgarten/classroom'
import type { Server } from '@botgarten/classroom/testing'
import { beforeEach, expect, test } from 'vitest'
import { askerOn, freshServer } from '../testing/class-server.ts'
import { ClassApi } from './api.ts'
import { Rehearsal } from './rehearsal.svelte.ts'
import { secondsLabel } from './times.ts'

type Rehearse = Server['ports']['host']['rehearse']

let server: Server
let rehearsal: Rehearsal
/** What the server's machine does in place of a lesson. */
let played: Rehearse

beforeEach(async () => {
  server = await freshServer()
  const host = { ...server.ports.host, rehearse: ((...given) => played(...given)) satisfies Rehearse }
  Object.assign(server, { ports: { ...server.ports, host } })
  const api = new ClassApi(askerOn(server))
  const token = (await firstTeacherToken(server.ports))!
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  rehearsal = new Rehearsal(api)
})

const progress = { pupils: 35, joined: 35, saves: 280, slowest: 40, seconds: 42, of: 60 }
const outcome = { green: true, pupils: 35, saves: 420, lost: 0, p99: 31, slowest: 44, rss: 150 }

test('it is followed second by second to a green end', async () => {
  played = ({ pupils, seconds }, hear) => {
    expect({ pupils, seconds }).toEqual({ pupils: 35, seconds: 60 })
    hear(progress)
    return Promise.resolve(outcome)
  }
  await rehearsal.play()
  expect(rehearsal).toMatchObject({ state: 'green', progress, outcome: { saves: 420, lost: 0 } })
})

test('an end in red has its figures', async () => {
  played = () => Promise.resolve({ ...outcome, green: false, p99: 1900 })
  await rehearsal.play()
  expect(rehearsal).toMatchObject({ state: 'red', outcome: { p99: 1900 } })
})

test('a rehearsal that the machine cannot play is broken, and the next one may go well', async () => {
  played = () => Promise.reject(new Error('no room'))
  await rehearsal.play()
  expect(rehearsal).toMatchObject({ state: 'broken', outcome: null, refused: null })
  expect(server.logged).toContainEqual(expect.objectContaining({ route: '/rehearsal', status: 500 }))
  played = () => Promise.resolve(outcome)
  await rehearsal.play()
  expect(rehearsal.state).toBe('green')
})

test('one at a time, and none while somebody is in a class', async () => {
  played = () => null
  await rehearsal.play()
  expect(rehearsal).toMatchObject({ state: 'before', refused: 'rehearses' })
  Object.defineProperty(server.ports.live, 'size', { get: () => 1 })
  await rehearsal.play()
  expect(rehearsal).toMatchObject({ state: 'before', refused: 'lessonRuns' })
})

test('stopped, the server is told, and what it still sends changes nothing', async () => {
  const stopped = new Promise<void>((told) => {
    played = (_wish, hear, signal) => {
      hear(progress)
      return new Promise((_done, fail) =>
        signal.addEventListener('abort', () => (told(), fail(new Error('stopped')))),
      )
    }
  })
  const whole = rehearsal.play()
  await expect.poll(() => rehearsal.progress?.saves).toBe(280)
  rehearsal.stop()
  await Promise.all([whole, stopped])
  expect(rehearsal).toMatchObject({ state: 'stopped', refused: null })
})

test.each([
  [42, 'en', '0.04'],
  [1340, 'de', '1,3'],
  [12_400, 'en', '12'],
])('%i ms in %s are %s seconds', (ms, locale, label) => expect(secondsLabel(ms, locale)).toBe(label))
