import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { openClassServer, writeLink } from './class-server.ts'
import { syncedBy } from './data-folder.ts'
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

test('a broken database is reported at every start until a backup is taken or a new one is wanted', async () => {
  await (await openClassServer({ data: folder })).close()
  writeFileSync(
    join(folder, 'botgarten.db'),
    'not a database at all, but long enough to be read '.repeat(200),
  )
  expect(await problemOf({ data: folder })).toBe('broken')
  expect(await problemOf({ data: folder })).toBe('broken')
  await (await openClassServer({ data: folder, startOver: true })).close()
  await (await openClassServer({ data: folder })).close()
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
