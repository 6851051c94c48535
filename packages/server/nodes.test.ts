import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { noPostgres, startPostgres, type Postgres } from '@botgarten/classroom/testing/postgres'
import { Events } from '@botgarten/classroom/testing/events'
import pg from 'pg'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { openClassServer, type ClassServer } from './class-server.ts'
import { lettersOf } from './postgres-bus.ts'

interface Node {
  readonly classServer: ClassServer
  readonly http: Server
  readonly url: string
}

const why = noPostgres()

describe.skipIf(why !== null)(`two nodes on one PostgreSQL${why ? ` (skipped: ${why})` : ''}`, () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-nodes-'))
  let postgres: Postgres
  let address: string
  let nodes: Node[] = []
  let id = ''
  let teacher = ''
  let pupil = ''
  let pupilId = ''

  async function nodeNumber(at: number): Promise<Node> {
    const classServer = await openClassServer({ data: join(folder, `node-${at}`), database: address })
    const http = createServer((request, response) => void classServer.answer(request, response))
    await new Promise<void>((done) => http.listen(0, '127.0.0.1', done))
    return { classServer, http, url: `http://127.0.0.1:${(http.address() as AddressInfo).port}` }
  }

  /** @returns the status, the body, and the cookies as they are sent again */
  async function ask(at: number, method: string, path: string, cookie: string, body?: unknown) {
    const { url } = nodes[at]!
    const headers = { origin: url, cookie, 'content-type': 'application/json' }
    const answer = await fetch(`${url}/api/class${path}`, {
      ...{ method, headers, body: body === undefined ? null : JSON.stringify(body) },
    })
    const cookies = answer.headers.getSetCookie().map((line) => line.split(';')[0]!)
    const text = await answer.text()
    return {
      status: answer.status,
      body: (text === '' ? null : JSON.parse(text)) as never,
      cookie: cookies.join('; '),
    }
  }

  const events = async (at: number, path: string, cookie: string) =>
    new Events(await fetch(`${nodes[at]!.url}/api/class${path}`, { headers: { cookie } }))

  beforeAll(async () => {
    postgres = await startPostgres()
    address = await postgres.newDatabase()
    const key = join(folder, 'shared.key')
    writeFileSync(key, Buffer.alloc(32, 7))
    process.env['BOTGARTEN_KEY'] = key
    nodes = [await nodeNumber(0)]
    nodes.push(await nodeNumber(1))
    const token = await nodes[0]!.classServer.firstTeacher()
    ;({ cookie: teacher } = await ask(0, 'POST', '/teachers', '', {
      token,
      username: 'm.weber',
      password: 'kastanie im regen',
    }))
    const made = { name: '5b', language: 'en', grade: 5, endsOn: '2099-01-31' }
    ;({ id } = (await ask(1, 'POST', '/classes', teacher, made)).body)
    await ask(0, 'POST', `/classes/${id}/open`, teacher)
    const { words }: { words: string[] } = (await ask(1, 'GET', `/classes/${id}`, teacher)).body
    const joined = await ask(0, 'POST', '/join', '', { code: words.join(' '), nickname: 'Fuchs' })
    pupil = joined.cookie
    ;({ id: pupilId } = joined.body)
    // PostgreSQL takes its time to start on a busy machine.
  }, 60_000)

  afterAll(async () => {
    for (const { http, classServer } of nodes) {
      await classServer.ports.live.close()
      http.closeAllConnections()
      http.close()
      await classServer.close()
    }
    delete process.env['BOTGARTEN_KEY']
    await postgres.stop()
    rmSync(folder, { recursive: true, force: true })
  })

  const report = {
    ...{ card: 'fear', project: null, checks: ['open'], failed: 0, running: true, idle: 0 },
    ...{ size: null, pose: null, trail: [1, 2] },
  }

  test('who has joined at one is known at the other', async () => {
    expect((await ask(1, 'GET', '/me', pupil)).body).toMatchObject({ nickname: 'Fuchs' })
  })

  test('a report at one reaches the teacher at the other, and attention the other way', async () => {
    const view = await events(1, `/classes/${id}/stream`, teacher)
    const child = await events(0, '/me/stream', pupil)
    await child.next()
    await view.next()
    await ask(0, 'PUT', '/me/here', pupil, report)
    const heard = await view.until(({ event }) => event === 'tiles')
    expect(heard.data).toMatchObject({ tiles: [{ id: pupilId, live: { card: 'fear' } }] })
    await ask(1, 'PUT', `/classes/${id}/attention`, teacher, { on: true })
    await child.until(({ data }) => (data as { attention: number | null }).attention !== null)
    await ask(1, 'PUT', `/classes/${id}/attention`, teacher, { on: false })
    await child.until(({ data }) => (data as { attention: number | null }).attention === null)
    await view.stop()
    await child.stop()
  })

  test('after the connection was cut both go on, and streams are given the state again', async () => {
    const child = await events(0, '/me/stream', pupil)
    await child.next()
    const client = new pg.Client({ connectionString: address })
    await client.connect()
    await client.query(
      `select pg_terminate_backend(pid) from pg_stat_activity where application_name = 'botgarten-live'`,
    )
    await client.end()
    await child.until(({ event }) => event === 'state')
    await ask(1, 'POST', `/classes/${id}/handouts`, teacher, {
      to: 'all',
      kind: 'hint',
      card: 'fear',
      hint: 1,
    })
    await expect
      .poll(async () => ((await ask(0, 'GET', '/me', pupil)).body as { handouts: unknown[] }).handouts.length)
      .toBe(1)
    await child.stop()
  })

  test('a lesson that is closed at one ends the streams at the other', async () => {
    const child = await events(0, '/me/stream', pupil)
    await child.next()
    // Until both listen again after the cut, a message may be lost: the close is repeated until it arrives.
    const end = child.until(({ event }) => event === 'end')
    let heard = false
    void end.then(() => (heard = true))
    await expect
      .poll(async () => {
        await ask(1, 'POST', `/classes/${id}/close`, teacher)
        return heard
      })
      .toBe(true)
    expect((await end).data).toEqual({ reason: 'closed' })
  })

  test('a node with another key is refused', async () => {
    delete process.env['BOTGARTEN_KEY']
    const opened = openClassServer({ data: join(folder, 'stranger'), database: address })
    await expect(opened).rejects.toMatchObject({ problem: 'otherKey' })
    process.env['BOTGARTEN_KEY'] = join(folder, 'shared.key')
  })
})

test('however much pupils report at once, no notification is longer than PostgreSQL takes, and none is left out', () => {
  const live = {
    ...{ card: 'fear', project: null, checks: [], failed: 0, running: true },
    ...{ size: null, pose: null },
  }
  const tiles = Array.from({ length: 35 }, (_, at) => ({
    id: `pupil-${at}`,
    live: { ...live, trail: Array.from({ length: 320 }, () => -9999), seenAt: 1, changedAt: 1 },
  }))
  const letters = lettersOf('node', { kind: 'tiles', class: 'class', tiles })
  for (const letter of letters) expect(Buffer.byteLength(letter)).toBeLessThan(8000)
  const sent = letters.flatMap(
    (letter) => (JSON.parse(letter) as { message: { tiles: unknown[] } }).message.tiles,
  )
  expect(sent).toEqual(tiles)
})
