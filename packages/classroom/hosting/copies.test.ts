// When deleted classes and pupils are gone from every copy on the server.
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, beforeAll, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { deleteForGood } from '../teaching/deleting.ts'
import { everyNight } from '../teaching/every-night.ts'
import { filesWith } from '../testing/copies.ts'
import { openedIn } from '../testing/databases.ts'
import { quickHashes, Server } from '../testing/world.ts'
import { accountsOn } from '../teaching/accounts.ts'
import { backup, lastBackup, nightliesIn } from './backups.ts'
import { daysOfCopies, otherCopiesIn, pruneCopies, renewCopies } from './copies.ts'
import { databaseIn, openDataFolder, secretIn } from './data-folder.ts'
import { phraseOf } from './phrase-store.ts'
import { isReadable } from './read-back.ts'
import { restore } from './restore.ts'
import { bury } from './tombstones.ts'

const aDay = 86_400_000
/** The first day, a Saturday. The sample was made the day before. */
const start = Date.UTC(2026, 10, 28, 9)
const dayAt = (days: number) => new Date(start + days * aDay).toISOString().slice(0, 10)
const on = (days: number) => ({ day: dayAt(days), oldest: dayAt(days - daysOfCopies) })
const sample = join(import.meta.dirname, '..', 'samples', 'a62d0d78')

const made: string[] = []
const fresh = () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-copies-'))
  made.push(folder)
  return folder
}
afterAll(() => {
  for (const folder of made) rmSync(folder, { recursive: true })
})

function serverOn(folder: string, database: Database, days: number) {
  const secret = secretIn(folder)
  const server = new Server(database, {
    ...{ secret, accounts: accountsOn(database, secret, Date.now, quickHashes) },
    bury: (tombstone) => Promise.resolve(bury(folder, tombstone)),
  })
  server.now = start + days * aDay
  return server
}

interface Run {
  readonly folder: string
  /** On which day after the first one the server is started, … */
  readonly days: number
  readonly clockDoubted?: boolean
  /** … and what happens after its work of the night. */
  readonly work?: (server: Server) => Promise<void>
}

/** Starts a server, lets it do its work of the night, and stops it. */
async function run({ folder, days, clockDoubted = false, work }: Run): Promise<void> {
  const database = await openedIn(folder)
  const server = serverOn(folder, database, days)
  await everyNight(server.ports)
  await renewCopies({ database, folder, secret: secretIn(folder), clockDoubted, ...on(days) })
  await work?.(server)
  await database.close()
}

function damage(file: string) {
  const bytes = readFileSync(file)
  bytes.fill(0xff, 4096 * 2, 4096 * 6)
  writeFileSync(file, bytes)
}

/** A folder of the sample with each kind of copy that the product makes, and a class in each of them. */
let home: string
let phrase: string
let known: { readonly class: string; readonly code: string; readonly pupils: readonly { nickname: string }[] }
let words: readonly string[]

/** The sample's copies and those of the update and of its first two days. */
async function firstDays() {
  cpSync(sample, home, { recursive: true })
  rmSync(join(home, 'known.json'))
  await run({
    ...{ folder: home, days: 0 },
    work: async ({ ports }) => {
      phrase = await phraseOf(ports.database, ports.secret)
    },
  })
  await run({ folder: home, days: 1 })
}

/** The database is damaged and set aside; the last backup takes its place, and another one the place of that. */
async function damagedAndRestored() {
  damage(databaseIn(home))
  const opening = { secret: secretIn(home), day: dayAt(1) }
  expect(await openDataFolder(home, opening)).toMatchObject({ kind: 'broken' })
  for (let times = 0; times < 2; times++)
    expect(await restore(home, lastBackup(home)!.file, { day: dayAt(1), phrase })).toMatchObject({
      kind: 'restored',
    })
}

beforeAll(async () => {
  home = fresh()
  known = JSON.parse(readFileSync(join(sample, 'known.json'), 'utf8')) as typeof known
  words = known.pupils.map(({ nickname }) => nickname)
  await firstDays()
  await damagedAndRestored()
  await run({ folder: home, days: 2 })
})

const copyOfHome = () => {
  const folder = fresh()
  cpSync(home, folder, { recursive: true })
  return folder
}
const deleteClass = ({ ports }: Server) => deleteForGood(ports, { kind: 'class', id: known.class })

test('before the deletion each kind of copy has the class', async () => {
  expect(await filesWith(words, home, phrase)).toEqual([
    'backups/000001-2026-11-29.age',
    'backups/000002-2026-11-30.age',
    'backups/2026-11-28.db',
    'backups/before-migration.age',
    'botgarten.db',
    'botgarten.db.before-restore-1',
    'botgarten.db.broken-1.before-restore-1',
  ])
})

test.each([1, 3, 7, 30])(
  'a deleted class is in no copy from the seventh day on, once a server has run that runs every %i days',
  async (rhythm) => {
    const folder = copyOfHome()
    await run({ folder, days: 2, work: deleteClass })
    const promised = 2 + 7
    let days = 2
    // It is found until then.
    while (days < promised) {
      const found = await filesWith(words, folder, phrase)
      expect(found).not.toEqual([])
      expect(found).not.toContain('botgarten.db')
      days += rhythm
      await run({ folder, days })
    }
    expect(await filesWith(words, folder, phrase)).toEqual([])
    expect(lastBackup(folder)!.day).toBe(dayAt(days))
  },
)

test('a deleted class is in no copy and in no journal while the server runs on', async () => {
  const folder = copyOfHome()
  await run({
    ...{ folder, days: 2 },
    work: async (server) => {
      const { database } = server.ports
      await deleteClass(server)
      const stored = { database, folder, secret: secretIn(folder), clockDoubted: false }
      for (const days of [3, 9]) await renewCopies({ ...stored, ...on(days) })
      expect(existsSync(`${databaseIn(folder)}-wal`)).toBe(true)
      expect(await filesWith(words, folder, phrase)).toEqual([])
    },
  })
})

test('a pupil who is deleted is in no copy from the seventh day on, and the others are', async () => {
  const folder = copyOfHome()
  await run({
    ...{ folder, days: 2 },
    work: async ({ ports }) => {
      const pupils = await ports.database.db.selectFrom('pupil').selectAll().execute()
      const { id } = pupils.find(({ nickname }) => nickname === words[0])!
      await deleteForGood(ports, { kind: 'pupil', id })
    },
  })
  await run({ folder, days: 9 })
  expect(await filesWith([words[0]!], folder, phrase)).toEqual([])
  expect(await filesWith([words[1]!], folder, phrase)).toHaveLength(2)
})

test('copies are known by the names that the product gives, with their journals and keys; other files stay', () => {
  const folder = fresh()
  const ours = [
    ...[
      'botgarten.db.before-restore-2',
      'botgarten.db.before-restore-2-wal',
      'botgarten.db.before-restore-2-shm',
    ],
    ...[
      'answers.db.before-restore-12',
      'secret.key.before-restore-1',
      'botgarten.db.broken-1.before-restore-1-wal',
    ],
    ...['2026-11-20.answers.db', 'before-migration.db', 'before-migration.answers.db'].map(
      (name) => `backups/${name}`,
    ),
  ]
  const others = [
    ...['deleted.jsonl', 'notes.before-restore.txt', 'botgarten.db', 'answers.db.broken-1'],
    ...['backups/stick.age', 'backups/2026-11-20.txt'],
  ]
  mkdirSync(join(folder, 'backups'))
  for (const name of [...ours, ...others]) writeFileSync(join(folder, name), 'x')
  for (const days of [0, 7]) pruneCopies(folder, { ...on(days), clockDoubted: false })
  expect(ours.filter((name) => existsSync(join(folder, name)))).toEqual([])
  expect(others.filter((name) => !existsSync(join(folder, name)))).toEqual([])
})

test('while the clock is doubted no copy is deleted; after that they go by the days on which they were seen', async () => {
  const folder = copyOfHome()
  const copies = () => [...otherCopiesIn(folder).byAge, ...nightliesIn(folder).map(({ day }) => day)]
  const before = copies()
  for (const days of [400, 401]) await run({ folder, days, clockDoubted: true })
  expect(copies()).toEqual([...before, dayAt(400), dayAt(401)])
  // The clock was wrong: it is the fourth day.
  await run({ folder, days: 4 })
  expect(copies()).toEqual([...before, dayAt(400), dayAt(401), dayAt(4)])
  await run({ folder, days: 10 })
  expect(nightliesIn(folder).map(({ day }) => day)).toEqual([dayAt(400), dayAt(401), dayAt(4), dayAt(10)])
  await run({ folder, days: 11 })
  expect(copies()).toEqual([dayAt(10), dayAt(11)])
})

test('a clock that went back while it was doubted makes no copy older than it is', async () => {
  const folder = copyOfHome()
  const back = -20_000
  await run({ folder, days: back, clockDoubted: true })
  await run({ folder, days: 3 })
  expect(nightliesIn(folder).map(({ day }) => day)).toContain(dayAt(back))
})

test('the last backup stays until there is a newer one, however old it is', async () => {
  const folder = copyOfHome()
  const database = await openedIn(folder)
  const full = () => Promise.reject(Object.assign(new Error('No room.'), { code: 'ENOSPC' }))
  const stored = { folder, secret: secretIn(folder), clockDoubted: false }
  const failing = { ...stored, database: { ...database, backup: full } }
  await expect(renewCopies({ ...failing, ...on(100) })).rejects.toThrow('No room.')
  expect(nightliesIn(folder).map(({ day }) => day)).toEqual([dayAt(2)])
  expect(otherCopiesIn(folder).byAge).toEqual([])
  await renewCopies({ ...stored, database, ...on(101) })
  expect(nightliesIn(folder).map(({ day }) => day)).toEqual([dayAt(101)])
  await database.close()
})

test('a backup that cannot be read back gets no name and leaves the one before', async () => {
  const folder = copyOfHome()
  const database = await openedIn(folder)
  const { file } = lastBackup(folder)!
  const before = readFileSync(file)
  const stored = { database, folder, secret: secretIn(folder), day: dayAt(3) }
  const unreadable = backup(stored, file, () => Promise.resolve(false))
  await expect(unreadable).rejects.toThrow('cannot be read back')
  expect(readFileSync(file).equals(before)).toBe(true)
  expect(readdirSync(join(folder, 'backups')).filter((name) => name.startsWith('unfinished'))).toEqual([])
  await database.close()
})

test('a backup is readable with its phrase, and neither with another one nor after a change', async () => {
  const { file } = lastBackup(home)!
  expect(await isReadable(file, phrase)).toBe(true)
  expect(await isReadable(file, 'kite-otter-plum')).toBe(false)
  const bytes = readFileSync(file)
  const changed = join(fresh(), 'changed.age')
  for (const broken of [bytes.subarray(0, -100), bytes.with(bytes.length - 5000, 0).with(5000, 0)]) {
    writeFileSync(changed, broken)
    expect(await isReadable(changed, phrase).catch(() => false)).toBe(false)
  }
})

test('a damaged database that was set aside stays until a backup is restored, and a week longer', async () => {
  const folder = copyOfHome()
  damage(databaseIn(folder))
  await openDataFolder(folder, { secret: secretIn(folder), day: dayAt(2) })
  // Started over: an empty database.
  for (const days of [3, 13, 23]) {
    await (await openedIn(folder)).close()
    pruneCopies(folder, { ...on(days), clockDoubted: false })
  }
  expect(otherCopiesIn(folder)).toEqual({ byAge: [], broken: ['botgarten.db.broken-1'] })
  await restore(folder, lastBackup(folder)!.file, { day: dayAt(24), phrase })
  expect(otherCopiesIn(folder).broken).toEqual([])
  const aside = join(folder, 'botgarten.db.broken-1.before-restore-1')
  for (const days of [24, 30]) await run({ folder, days })
  expect(existsSync(aside)).toBe(true)
  await run({ folder, days: 31 })
  expect(otherCopiesIn(folder)).toEqual({ byAge: [], broken: [] })
})
