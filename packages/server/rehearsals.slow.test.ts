import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Events } from '@botgarten/classroom/testing/events'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { openClassServer, type ClassServer } from './class-server.ts'

let folder: string
let classServer: ClassServer
let http: Server
let url: string
let cookie: string

const ask = (path: string, body: unknown) =>
  fetch(`${url}/api/class${path}`, {
    method: 'POST',
    headers: { origin: url, cookie, 'content-type': 'application/json' },
    body: JSON.stringify(body),
  })
const rehearse = (seconds: number) => ask('/rehearsal', { pupils: 2, seconds })

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'botgarten-rehearsals-'))
  classServer = await openClassServer({ data: folder })
  http = createServer((request, response) => void classServer.answer(request, response))
  await new Promise<void>((done) => http.listen(0, '127.0.0.1', done))
  url = `http://127.0.0.1:${(http.address() as AddressInfo).port}`
  cookie = ''
  const token = await classServer.firstTeacher()
  const made = await ask('/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  cookie = made.headers
    .getSetCookie()
    .map((line) => line.split(';')[0])
    .join('; ')
}, 30_000)

afterAll(async () => {
  http.closeAllConnections()
  http.close()
  await classServer.close()
  rmSync(folder, { recursive: true, force: true })
})

const inFolder = () => readdirSync(folder).toSorted()

test('a rehearsal is played beside the server, tells how it goes, and leaves nothing', async () => {
  const [before, data] = [inFolder(), readFileSync(join(folder, 'botgarten.db'))]
  const events = new Events(await rehearse(1))
  const first = await events.next()
  expect(first).toMatchObject({ event: 'progress', data: { pupils: 2, joined: 0, seconds: 0, of: 1 } })
  // While it is played, a second one is refused.
  expect((await rehearse(1)).status).toBe(409)
  const { event, data: outcome } = await events.until((heard) => heard.event !== 'progress')
  expect(event).toBe('done')
  expect(outcome).toMatchObject({ pupils: 2, saves: 1, lost: 0 })
  expect((outcome as { rss: number }).rss).toBeGreaterThan(20)
  expect(inFolder()).toEqual(before)
  expect(readFileSync(join(folder, 'botgarten.db')).equals(data)).toBe(true)
}, 60_000)

test('who goes away ends the rehearsal, and nothing of it is left', async () => {
  const before = inFolder()
  const stopped = new Events(await rehearse(300))
  await stopped.until(({ data }) => (data as { joined: number }).joined === 2)
  expect(inFolder()).not.toEqual(before)
  await stopped.stop()
  await expect.poll(inFolder, { timeout: 20_000 }).toEqual(before)
}, 60_000)
