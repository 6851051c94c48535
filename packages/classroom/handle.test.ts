import { beforeAll, expect, test, vi } from 'vitest'
import { openSqlite } from './database/sqlite.ts'
import { migrate } from './database/migrate.ts'
import { routes } from './routes.ts'
import type { Browser } from './testing/browser.ts'
import { projectText } from './testing/projects.ts'
import { Server } from './testing/world.ts'

let server: Server
let teacher: Browser
let code: string

beforeAll(async () => {
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database)
  teacher = await server.firstTeacher()
  ;({ code } = await server.openClass(teacher))
})

const look = (headers: Record<string, string>) =>
  server.browser().ask('POST', '/look', JSON.stringify({ code }), headers)

test('a page of somebody else changes nothing, on any route', async () => {
  for (const { method, path } of routes) {
    if (method === 'GET') continue
    for (const origin of ['http://evil.test', 'null', 'http://lab.test.evil.test', 'http://lab.test:81']) {
      const answer = await teacher.twin().ask(method, path.replaceAll(/:\w+/g, 'some-thing'), {}, { origin })
      expect(answer, `${method} ${path} from ${origin}`).toMatchObject({
        status: 403,
        body: { error: 'foreignPage' },
      })
    }
  }
})

test.each([
  ['same-origin', 404],
  ['none', 404],
  ['same-site', 403],
  ['cross-site', 403],
])('a request from a page whose browser calls it %s is answered %i', async (site, status) => {
  const headers = { 'sec-fetch-site': site }
  expect((await server.browser().ask('POST', '/look', { code: 'x' }, headers)).status).toBe(status)
})

test('a request without an origin changes nothing', async () => {
  const request = new Request('http://lab.test/api/class/look', { method: 'POST', body: '{}' })
  expect((await server.ask(request)).status).toBe(403)
})

test('behind a proxy the page has the public address', async () => {
  const open = new Server(server.ports.database, {
    publicOrigin: 'https://lab.example.org',
    accounts: server.ports.accounts,
  })
  open.now = server.now
  const answer = await open.browser().ask('POST', '/look', { code }, { origin: 'https://lab.example.org' })
  expect(answer.status).toBe(200)
})

test('a body is JSON, says so, and is no larger than its route takes', async () => {
  expect((await look({ 'content-type': 'text/plain' })).status).toBe(415)
  const browser = server.browser()
  expect((await browser.ask('POST', '/look', '{"code":')).status).toBe(400)
  expect((await browser.ask('POST', '/look', { code, more: 1 })).status).toBe(400)
  expect((await browser.ask('POST', '/look', { code: 'x'.repeat(20_000) })).status).toBe(413)
  const child = (await server.pupil(code, 'Riese')).browser
  const big = projectText('x'.repeat(5_000_000))
  expect((await child.put('/projects/project-1?base=0&save=save-0001', big)).status).toBe(413)
})

test('a body that hides its length is cut off at the limit', async () => {
  const child = (await server.pupil(code, 'Endlos')).browser
  let sent = 0
  const endless = new ReadableStream<Uint8Array>({
    pull: (controller) => {
      sent += 65_536
      controller.enqueue(new Uint8Array(65_536).fill(32))
    },
  })
  const cookie = [...child.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
  const headers = { cookie, origin: 'http://lab.test', 'content-type': 'application/json' }
  const url = 'http://lab.test/api/class/projects/project-1?base=0&save=save-0001'
  const request = new Request(url, { method: 'PUT', body: endless, headers, duplex: 'half' })
  expect((await server.ask(request)).status).toBe(413)
  expect(sent).toBeLessThan(6_000_000)
})

test('what is no route is 404, and another method 405 with those that are', async () => {
  expect((await teacher.get('/nothing')).status).toBe(404)
  const answer = await teacher.delete('/classes')
  expect(answer.status).toBe(405)
  expect(answer.headers.get('allow')).toBe('GET, POST')
})

test('of the paths of better-auth three are there and all others are not', async () => {
  const { betterAuth } = await import('better-auth')
  const { username } = await import('better-auth/plugins/username')
  const { api } = betterAuth({
    plugins: [username()],
    emailAndPassword: { enabled: true },
    secret: 'x'.repeat(40),
    baseURL: 'http://lab.test',
  })
  const paths = Object.values(api).map(({ path }: { path?: string }) => path)
  const there = []
  for (const path of new Set(paths))
    for (const method of ['GET', 'POST']) {
      const { status } = await server
        .browser()
        .ask(method, `/auth${path}`, method === 'POST' ? {} : undefined)
      if (status !== 404 && status !== 405) there.push(`${method} ${path}`)
    }
  expect(there.toSorted()).toEqual(['GET /get-session', 'POST /sign-in/username', 'POST /sign-out'])
  expect(paths.length).toBeGreaterThan(20)
})

test('cookies are out of the reach of scripts, stay on this site, and are Secure under https', async () => {
  for (const secure of [false, true]) {
    const headers = { origin: 'http://lab.test', 'content-type': 'application/json' }
    const requests = [
      // The first wrong try of a device gives it a name.
      ['look', { code: 'no such code' }],
      ['auth/sign-in/username', { username: 'm.weber', password: 'kastanie im regen' }],
    ] as const
    for (const [path, body] of requests) {
      const url = `http://lab.test/api/class/${path}`
      const answer = await server.ask(
        new Request(url, { method: 'POST', body: JSON.stringify(body), headers }),
        { secure },
      )
      const cookies = answer.headers.getSetCookie()
      expect(cookies.length).toBeGreaterThan(0)
      for (const cookie of cookies) {
        expect(cookie).toMatch(/httponly/i)
        expect(cookie).toMatch(/samesite=lax/i)
        expect(cookie).toMatch(/path=\/api\/class/i)
        expect(/; *secure/i.test(cookie)).toBe(secure)
      }
    }
  }
})

test('a device that sends too many requests is refused without a query until its time is over', async () => {
  const { database, accounts } = server.ports
  const own = new Server(database, { accounts })
  own.holdClock()
  const { browser } = await own.pupil(code, 'Eilig')
  for (let count = 0; count < 300; count++) await browser.get('/projects')
  const refused = { status: 429, body: { error: 'tooFast', seconds: 1 } }
  expect(await browser.get('/projects')).toMatchObject(refused)
  const queries = vi.spyOn(database.db, 'selectFrom')
  expect(await browser.get('/projects')).toMatchObject(refused)
  expect(queries).not.toHaveBeenCalled()
  queries.mockRestore()
  own.later(0.02)
  expect((await browser.get('/projects')).status).toBe(200)
})

test('the log holds routes and codes, and no nickname, address, code of a class or id', async () => {
  const child = await server.pupil(code, 'Geheimname')
  await child.browser.post('/join', { code, nickname: 'Geheimname' })
  await child.browser.put('/projects/project-77?base=0&save=save-0001', projectText('geheim'))
  await server.browser('203.0.113.9').post('/look', { code: 'kite otter plum' })
  const text = JSON.stringify(server.logged)
  for (const secret of [
    'Geheimname',
    '203.0.113',
    'kite',
    code,
    child.id,
    child.class,
    'project-77',
    'm.weber',
  ])
    expect(text).not.toContain(secret)
  expect(server.logged.at(-2)).toEqual({ method: 'PUT', route: '/projects/:project', status: 200 })
})

test('an error of the database is logged by its code alone', async () => {
  const { database } = server.ports
  const logged: unknown[] = []
  const failing = new Server(database, {
    accounts: server.ports.accounts,
    save: () => Promise.reject(Object.assign(new Error('Key (nickname)=(Fuchs)'), { code: '53100' })),
    log: (line) => void logged.push(line),
  })
  failing.now = server.now
  const child = await failing.pupil(code, 'Pechvogel')
  const answer = await child.browser.put('/projects/project-1?base=0&save=save-0001', projectText('a'))
  expect(answer).toMatchObject({ status: 507, body: { error: 'diskFull' } })
  expect(logged.at(-1)).toEqual({ method: 'PUT', route: '/projects/:project', status: 507, error: '53100' })
})

test('a fault of ours is logged by its name and place, and never by its message', async () => {
  const logged: { error?: string }[] = []
  const failing = new Server(server.ports.database, {
    accounts: server.ports.accounts,
    cards: () => Promise.reject(new Error('Fuchs is no card\n    at /srv/Fuchs.ts:1:2')),
    log: (line) => void logged.push(line),
  })
  failing.now = server.now
  const { id } = ((await teacher.get('/classes')).body as { classes: { id: string }[] }).classes[0]!
  const browser = failing.browser()
  for (const [name, value] of teacher.cookies) browser.cookies.set(name, value)
  expect(await browser.get(`/classes/${id}/results`)).toMatchObject({
    status: 500,
    body: { error: 'ourFault' },
  })
  expect(logged.at(-1)!.error).toMatch(/^Error handle\.test\.ts:\d+$/)
})

test('signing in and joining ask nothing of the outside', async () => {
  const fetched = vi.spyOn(globalThis, 'fetch')
  const answer = await server
    .browser('203.0.113.7')
    .post('/auth/sign-in/username', { username: 'm.weber', password: 'kastanie im regen' })
  expect(answer.status).toBe(204)
  await server.pupil(code, 'Hausmaus')
  expect(fetched).not.toHaveBeenCalled()
  fetched.mockRestore()
})
