// A backup on another machine: with its file and its phrase alone.
import { hash } from 'node:crypto'
import {
  cpSync,
  existsSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  truncateSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import fc from 'fast-check'
import { sql } from 'kysely'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { openSqlite } from '../database/sqlite.ts'
import { storedIn, today, unpacked } from '../testing/backups.ts'
import { openedIn } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { quickHashes, Server } from '../testing/world.ts'
import { accountsOn } from '../teaching/accounts.ts'
import { backup, lastBackup, nightliesIn, nightlyBackup } from './backups.ts'
import { databaseIn, secretIn } from './data-folder.ts'
import { isKeyOf } from './key-store.ts'
import { phraseFrom, phraseOf } from './phrase-store.ts'
import { restore } from './restore.ts'
import { isSealed, openSealed, writeSealed } from './sealed-file.ts'
import { bury, buriedIn } from './tombstones.ts'

/** The server whose backups are tested: a class with a pupil who has saved. */
let home: string
let file: string
let phrase: string
let pupil: { readonly nickname: string; readonly pictures: readonly string[]; readonly code: string }

const serverOn = async (folder: string) => {
  const [database, secret] = [await openedIn(folder), secretIn(folder)]
  await isKeyOf(database, secret)
  const server = new Server(database, {
    ...{ secret, accounts: accountsOn(database, secret, Date.now, quickHashes) },
    bury: (tombstone) => Promise.resolve(bury(folder, tombstone)),
  })
  return { database, server }
}

const fresh = () => mkdtempSync(join(tmpdir(), 'botgarten-elsewhere-'))

beforeAll(async () => {
  home = fresh()
  file = join(home, 'copy.age')
  const { database, server } = await serverOn(home)
  const teacher = await server.firstTeacher()
  const { code } = await server.openClass(teacher)
  const { browser, pictures } = await server.pupil(code, 'Fuchs')
  await browser.put('/projects/project-1?base=0&save=save-on-0', projectText('1'))
  pupil = { nickname: 'Fuchs', pictures, code }
  const stored = storedIn(home, database)
  await backup(stored, file)
  phrase = await phraseOf(database, stored.secret)
  await database.close()
})
afterAll(() => rmSync(home, { recursive: true }))

/** Runs in an empty folder, which is removed after. */
async function elsewhere(work: (folder: string) => Promise<void>) {
  const folder = fresh()
  try {
    await work(folder)
  } finally {
    rmSync(folder, { recursive: true })
  }
}

test('on an empty machine file and phrase give a running server: pictures, password and work are right', () =>
  elsewhere(async (folder) => {
    expect(await restore(folder, file, { day: today, phrase })).toEqual({
      ...{ kind: 'restored', before: null, deletionsUnknown: true, day: today },
    })
    const { database, server } = await serverOn(folder)
    const child = server.browser()
    expect((await child.post('/return', pupil)).status).toBe(200)
    expect((await child.get('/projects/project-1')).body).toMatchObject({ revision: 1 })
    const teacher = server.browser()
    const password = { username: 'm.weber', password: 'kastanie im regen' }
    expect((await teacher.post('/auth/sign-in/username', password)).status).toBe(204)
    expect(await phraseOf(database, secretIn(folder))).toBe(phrase)
    await database.close()
  }))

test('the encrypted file shows no word of the class', () => {
  const bytes = readFileSync(file, 'latin1')
  expect(bytes.slice(0, 22)).toBe('age-encryption.org/v1\n')
  for (const secret of [
    'Fuchs',
    'm.weber',
    'SQLite format',
    'manifest',
    phrase,
    readFileSync(join(home, 'secret.key'), 'latin1'),
  ])
    expect(bytes).not.toContain(secret)
})

test('the phrase is nowhere in the data folder in the clear', () => {
  for (const name of readdirSync(home, { recursive: true, withFileTypes: true }).filter((one) =>
    one.isFile(),
  ))
    expect(readFileSync(join(name.parentPath, name.name), 'latin1')).not.toContain(phrase)
})

/** A folder with another server in it, which a refused restore must not change. */
async function refused(given: string, phraseGiven: string | null): Promise<string> {
  let kind = ''
  await elsewhere(async (folder) => {
    const { database, server } = await serverOn(folder)
    await server.firstTeacher('k.otto')
    await database.close()
    const bytes = (name: string) => hash('sha256', readFileSync(join(folder, name)))
    const before = [bytes('botgarten.db'), bytes('secret.key')]
    kind = (await restore(folder, given, { day: today, phrase: phraseGiven })).kind
    expect([bytes('botgarten.db'), bytes('secret.key')]).toEqual(before)
    expect(readdirSync(folder).filter((name) => name.includes('before-restore'))).toEqual([])
    expect(readdirSync(join(folder, 'backups'))).toEqual([])
  })
  return kind
}

test('without a phrase, or with another one, nothing is replaced', async () => {
  expect(await refused(file, null)).toBe('phraseNeeded')
  expect(await refused(file, phrase.replace(/-[a-z]+$/, '-zebra-zebra'))).toBe('wrongPhrase')
})

test('a file that was cut anywhere, or changed in one byte, replaces nothing', async () => {
  const whole = readFileSync(file)
  const broken = join(home, 'broken.age')
  const attempt = async (bytes: Buffer) => {
    writeFileSync(broken, bytes)
    const into = fresh()
    try {
      return (await openSealed(broken, phrase, into)).kind
    } finally {
      rmSync(into, { recursive: true })
    }
  }
  await fc.assert(
    fc.asyncProperty(fc.integer({ min: 0, max: whole.length - 1 }), async (at) => {
      expect(await attempt(whole.subarray(0, at))).not.toBe('opened')
      const changed = Buffer.from(whole)
      changed[at]! ^= 1
      expect(await attempt(changed)).not.toBe('opened')
    }),
    { numRuns: 6 },
  )
  writeFileSync(broken, whole)
  truncateSync(broken, whole.length - 100)
  expect(await refused(broken, phrase)).toBe('damaged')
})

/** A backup with other parts. */
async function sealedWith(change: (folder: string) => void | Promise<void>): Promise<string> {
  const [parts, changed] = [fresh(), join(home, 'changed.age')]
  const opened = await openSealed(file, phrase, parts)
  if (opened.kind !== 'opened') throw new Error(opened.kind)
  await change(parts)
  const paths = opened.names.map((name) => join(parts, name)).filter((path) => existsSync(path))
  await writeSealed(changed, paths, { day: today, phrase })
  rmSync(parts, { recursive: true })
  return changed
}

test('a backup whose database a newer version has written replaces nothing', async () => {
  const newer = await sealedWith(async (folder) => {
    const database = openSqlite(join(folder, 'botgarten.db'))
    await sql`insert into kysely_migration (name, timestamp) values ('step-999-later', '2030-01-01')`.execute(
      database.db,
    )
    await database.close()
  })
  expect(await refused(newer, phrase)).toBe('newer')
})

test('a backup whose manifest has a later version replaces nothing', async () => {
  const parts = fresh()
  await openSealed(file, phrase, parts)
  const manifest = JSON.parse(readFileSync(join(parts, 'manifest.json'), 'utf8')) as { version: number }
  expect(manifest).toMatchObject({ format: 'botgarten-backup', version: 1, day: today })
  rmSync(parts, { recursive: true })
  const later = join(home, 'later.age')
  await writeSealed(later, [databaseIn(home)], { day: today, phrase, version: 2 })
  expect(await refused(later, phrase)).toBe('newer')
})

test('a backup without its key, or with the key of another server, replaces nothing', async () => {
  const without = await sealedWith((folder) => rmSync(join(folder, 'secret.key')))
  expect(await refused(without, phrase)).toBe('notABackup')
  const other = await sealedWith((folder) => writeFileSync(join(folder, 'secret.key'), new Uint8Array(32)))
  expect(await refused(other, phrase)).toBe('otherKey')
})

test('a restore in place of another server renames its database, answers and key', () =>
  elsewhere(async (folder) => {
    await (await serverOn(folder)).database.close()
    const key = readFileSync(join(folder, 'secret.key'))
    expect(await restore(folder, file, { day: today, phrase })).toMatchObject({
      before: join(folder, 'botgarten.db.before-restore-1'),
    })
    expect(readFileSync(join(folder, 'secret.key.before-restore-1')).equals(key)).toBe(true)
    expect(existsSync(join(folder, 'answers.db.before-restore-1'))).toBe(true)
  }))

test('deletions before the backup are on its list, and the list of the old machine has the later ones', async () => {
  const { database, server } = await serverOn(home)
  const browser = server.browser()
  await browser.post('/auth/sign-in/username', { username: 'm.weber', password: 'kastanie im regen' })
  const { classes } = (await browser.get('/classes')).body as { classes: readonly { id: string }[] }
  const gone = await server.pupil(pupil.code, 'Zuvor')
  await browser.delete(`/classes/${classes[0]!.id}/pupils/${gone.id}`)
  const later = await server.pupil(pupil.code, 'Danach')
  const second = join(home, 'second.age')
  await backup(storedIn(home, database), second)
  await browser.delete(`/classes/${classes[0]!.id}/pupils/${later.id}`)
  await database.close()
  const nicknamesIn = async (folder: string) => {
    const opened = await openedIn(folder)
    const rows = await opened.db.selectFrom('pupil').select('nickname').orderBy('nickname').execute()
    await opened.close()
    return rows.map((row) => row.nickname)
  }
  await elsewhere(async (folder) => {
    await restore(folder, second, { day: today, phrase })
    expect(await nicknamesIn(folder)).toEqual(['Danach', 'Fuchs'])
    expect(buriedIn(folder)).toEqual([{ kind: 'pupil', id: gone.id }])
    const list = join(home, 'deleted.jsonl')
    expect(await restore(folder, second, { day: today, phrase, deleted: list })).toMatchObject({
      deletionsUnknown: false,
    })
    expect(await nicknamesIn(folder)).toEqual(['Fuchs'])
  })
})

test('a copy of the database of an earlier version is taken with the key that is next to it, and refused without', () =>
  elsewhere(async (folder) => {
    const sample = join(import.meta.dirname, '..', 'samples', 'a62d0d78')
    const [old] = readdirSync(join(sample, 'backups')).filter((name) => !name.includes('answers'))
    for (const name of readdirSync(join(sample, 'backups')))
      cpSync(join(sample, 'backups', name), join(folder, 'stick', name))
    const given = { day: today, phrase: null }
    const data = join(folder, 'data')
    expect(await restore(data, join(folder, 'stick', old!), given)).toEqual({ kind: 'otherKey' })
    expect(readdirSync(data)).toEqual(['backups'])
    cpSync(join(sample, 'secret.key'), join(folder, 'stick', 'secret.key'))
    expect(await restore(data, join(folder, 'stick', old!), given)).toMatchObject({
      kind: 'restored',
      day: null,
    })
    expect(readFileSync(join(data, 'secret.key')).equals(readFileSync(join(sample, 'secret.key')))).toBe(true)
  }))

test('before tables change the database is copied with encryption, and an earlier copy in the clear goes', () =>
  elsewhere(async (folder) => {
    cpSync(join(import.meta.dirname, '..', 'samples', 'a62d0d78'), folder, { recursive: true })
    for (const name of ['before-migration.db', 'before-migration.answers.db'])
      writeFileSync(join(folder, 'backups', name), 'Fuchs')
    const database = await openedIn(folder)
    const found = readdirSync(join(folder, 'backups')).filter((name) => name.startsWith('before-migration'))
    expect(found).toEqual(['before-migration.age'])
    const copy = await unpacked(
      join(folder, 'backups', 'before-migration.age'),
      await phraseOf(database, secretIn(folder)),
    )
    expect(copy['botgarten.db']).toContain('Fuchs')
    await database.close()
  }))

test('what a backup has left that was cut off goes at the next start', () =>
  elsewhere(async (folder) => {
    cpSync(home, join(folder, 'backups', 'unfinished-abc'), { recursive: true })
    await (await openedIn(folder)).close()
    expect(readdirSync(join(folder, 'backups'))).toEqual([])
  }))

test('a clock that was a year ahead leaves the order of the copies right', () =>
  elsewhere(async (folder) => {
    const database = await openedIn(folder)
    const stored = storedIn(folder, database)
    for (const day of ['2026-11-23', '2027-11-24', '2026-11-24', '2026-11-24'])
      await nightlyBackup({ ...stored, day })
    expect(nightliesIn(folder).map(({ day, number }) => `${number} ${day}`)).toEqual([
      ...['1 2026-11-23', '2 2027-11-24', '4 2026-11-24'],
    ])
    expect(lastBackup(folder)!.day).toBe('2026-11-24')
    await database.close()
  }))

test('the phrase has ten words and is taken as people type it', () => {
  expect(phrase.split('-')).toHaveLength(10)
  fc.assert(
    fc.property(
      fc.array(fc.constantFrom(' ', '\n', '-', ' - ', ', '), { minLength: 9, maxLength: 9 }),
      (marks) => {
        const typed = phrase
          .split('-')
          .map((word, at) => word.toUpperCase() + (marks[at] ?? ' '))
          .join('')
        expect(phraseFrom(typed)).toBe(phrase)
      },
    ),
  )
})

test('a backup that another implementation of age and of tar has made is opened', () =>
  elsewhere(async (folder) => {
    // reference/rage.py
    const rage = join(import.meta.dirname, 'reference', 'rage.age')
    const words = 'kite-otter-plum-rope-kite-otter-plum-rope-kite-otter'
    expect(await openSealed(rage, words, folder)).toEqual({
      ...{ kind: 'opened', day: '2026-11-24', names: ['botgarten.db', 'secret.key'] },
    })
    expect([...readFileSync(join(folder, 'secret.key'))]).toEqual(Array.from({ length: 32 }, (_, at) => at))
    expect(readFileSync(join(folder, 'botgarten.db'), 'utf8')).toBe('a database'.repeat(10_000))
  }))

test('two servers have two phrases', () =>
  elsewhere(async (folder) => {
    const database = await openedIn(folder)
    expect(await phraseOf(database, secretIn(folder))).not.toBe(phrase)
    await database.close()
  }))

test('what another program wrote is no encrypted file', async () => {
  const holiday = join(home, 'holiday.jpg')
  writeFileSync(holiday, 'x')
  expect(await isSealed(holiday)).toBe(false)
})
