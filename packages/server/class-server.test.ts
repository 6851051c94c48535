import { once } from 'node:events'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { openSqlite } from '@botgarten/classroom'
import { openClassServer, writeLink } from './class-server.ts'
import { brokenIn, syncedBy } from './data-folder.ts'
import type { CannotServe } from './problem.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-server-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

const problemOf = (options: Parameters<typeof openClassServer>[0]) =>
  openClassServer(options).then(
    () => 'none',
    (error: CannotServe) => error.problem,
  )

test('two servers on one folder: the second is refused, and after the first has ended it is not', async () => {
  const [one, other] = await Promise.allSettled([
    openClassServer({ data: folder }),
    openClassServer({ data: folder }),
  ])
  expect([one.status, other.status].toSorted()).toEqual(['fulfilled', 'rejected'])
  for (const each of [one, other]) if (each.status === 'fulfilled') await each.value.close()
  await (await openClassServer({ data: folder })).close()
})

test.each(['botgarten.db', 'answers.db'])(
  'a broken %s is reported at every start until a backup is restored or a new one is wanted',
  async (name) => {
    await (await openClassServer({ data: folder })).close()
    writeFileSync(join(folder, name), 'not a database at all, but long enough to be read '.repeat(200))
    expect(await problemOf({ data: folder })).toBe('broken')
    expect(await problemOf({ data: folder })).toBe('broken')
    await (await openClassServer({ data: folder, startOver: true })).close()
    await (await openClassServer({ data: folder })).close()
  },
)

test('data of a later version is not opened, and a sentence says so', async () => {
  await (await openClassServer({ data: folder })).close()
  const database = openSqlite(join(folder, 'botgarten.db'))
  const step = { name: 'step-999-later', timestamp: '' }
  await database.db
    .insertInto('kysely_migration' as never)
    .values(step)
    .execute()
  await database.close()
  expect(await problemOf({ data: folder })).toBe('newerData')
})

test.skipIf(process.platform === 'win32')(
  'the databases are for their owner alone, also in a folder that was there before',
  async () => {
    chmodSync(folder, 0o755)
    await (await openClassServer({ data: folder })).close()
    for (const name of ['botgarten.db', 'answers.db', 'secret.key'])
      expect(statSync(join(folder, name)).mode & 0o77).toBe(0)
  },
)

test('the newest of many broken databases is named', () => {
  for (const number of [1, 2, 10]) writeFileSync(join(folder, `answers.db.broken-${number}`), '')
  writeFileSync(join(folder, 'botgarten.db'), '')
  expect(brokenIn(folder)).toBe(join(folder, 'answers.db.broken-10'))
})

test.each([
  ['/home/weber/OneDrive - School/data', 'OneDrive'],
  ['/Users/weber/Dropbox/botgarten', 'Dropbox'],
  ['/Users/weber/Library/Mobile Documents/data', 'iCloud'],
  ['/home/weber/botgarten/data', null],
  ['/home/weber/my-dropbox-copy/data', null],
])('%s is synced by %s', (path, by) => expect(syncedBy(path)).toBe(by))

test('a folder that a program copies elsewhere is refused before anything is written into it', async () => {
  const synced = join(folder, 'Dropbox')
  mkdirSync(synced)
  expect(await problemOf({ data: join(synced, 'data') })).toBe('syncedFolder')
})

test('the link of the first teacher is a file for its owner alone, and goes when it was used', async () => {
  const server = await openClassServer({ data: folder })
  const file = writeLink(folder, `http://localhost/teacher/start#${await server.firstTeacher()}`)
  expect(statSync(file).mode & 0o777).toBe(0o600)
  const token = readFileSync(file, 'utf8').trim().split('#')[1]
  await server.ports.database.db.selectFrom('invitation').selectAll().executeTakeFirstOrThrow()
  server.ports.teacherMade()
  expect(token).toHaveLength(22)
  expect(() => statSync(file)).toThrow()
  await server.close()
})

/** A class server that is asked over HTTP by its first teacher. */
async function taught() {
  const classServer = await openClassServer({ data: folder })
  const http = createServer((request, response) => void classServer.answer(request, response))
  http.listen(0, '127.0.0.1')
  await once(http, 'listening')
  const url = `http://127.0.0.1:${(http.address() as AddressInfo).port}`
  let cookie = ''
  async function ask(method: string, path: string, body?: unknown) {
    const headers = { origin: url, cookie, 'content-type': 'application/json' }
    const text = body === undefined ? null : JSON.stringify(body)
    const answer = await fetch(`${url}/api/class${path}`, { method, headers, body: text })
    cookie ||= answer.headers
      .getSetCookie()
      .map((line) => line.split(';')[0]!)
      .join('; ')
    return answer
  }
  const token = await classServer.firstTeacher()
  await ask('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  return { classServer, http, ask }
}

test('what is being answered when a server closes still has its database', async () => {
  const { classServer, http, ask } = await taught()
  const made = await ask('POST', '/classes', { name: '5b', language: 'en', grade: 5, endsOn: '2099-01-31' })
  const { id } = (await made.json()) as { id: string }
  // It reads all cards first, and then the database.
  const [results] = [ask('GET', `/classes/${id}/results`), await once(http, 'request')]
  await classServer.close()
  expect((await results).status).toBe(200)
  http.close()
})
