import {
  appendFileSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { openedIn } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import { storedIn, today } from '../testing/backups.ts'
import { backup, lastBackup, nightlyBackup } from './backups.ts'
import { pruneCopies } from './copies.ts'
import { databaseIn, openDataFolder, secretIn } from './data-folder.ts'
import { phraseOf } from './phrase-store.ts'
import { restore } from './restore.ts'
import { bury, buriedIn } from './tombstones.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-data-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

const open = () => openedIn(folder)

/** Makes a backup. @returns restores it into a folder, with the phrase of its server */
async function backedUp(database: Database, file = join(folder, 'copy.age')) {
  const stored = storedIn(folder, database)
  await backup(stored, file)
  const phrase = await phraseOf(database, stored.secret)
  return { file, phrase, restore: (into = folder) => restore(into, file, { day: today, phrase }) }
}

async function serverOn(at = folder) {
  const database = await open()
  const server = new Server(database, { bury: (tombstone) => Promise.resolve(bury(at, tombstone)) })
  const teacher = await server.firstTeacher()
  const { id, code } = await server.openClass(teacher)
  return { database, server, teacher, id, code }
}

const save = (browser: { put(path: string, body: unknown): Promise<unknown> }, base: number) =>
  browser.put(`/projects/project-1?base=${base}&save=save-on-${base}`, projectText(`${base}`))

test('the key is made once, for its owner alone', () => {
  const key = secretIn(folder)
  expect(key).toHaveLength(32)
  expect(secretIn(folder)).toEqual(key)
  expect(statSync(join(folder, 'secret.key')).mode & 0o77).toBe(0)
})

test('a backup made while children save is sound and holds what was acknowledged before it', async () => {
  const { database, server, code } = await serverOn()
  const child = await server.pupil(code, 'Fuchs')
  for (let base = 0; base < 5; base++) await save(child.browser, base)
  const [copy] = await Promise.all([backedUp(database), save(child.browser, 5), save(child.browser, 6)])
  await database.close()
  expect(await copy.restore()).toMatchObject({ kind: 'restored' })
  const again = await open()
  const rows = await again.db.selectFrom('project').select('revision').execute()
  expect(rows[0]!.revision).toBeGreaterThanOrEqual(5)
  await again.close()
})

test('one copy a night is made, and seven are kept', async () => {
  const database = await open()
  const stored = storedIn(folder, database)
  for (let date = 10; date < 20; date++) {
    const day = `2026-11-${date}`
    await nightlyBackup({ ...stored, day })
    pruneCopies(folder, { day, oldest: `2026-11-${date - 7}`.replace(/-(\d)$/, '-0$1'), clockDoubted: false })
  }
  expect(readdirSync(join(folder, 'backups')).toSorted()).toEqual(
    Array.from({ length: 7 }, (_, at) => `00000${4 + at}-2026-11-${13 + at}.age`.slice(-21)),
  )
  expect(lastBackup(folder)).toMatchObject({ day: '2026-11-19', number: 10 })
  await database.close()
})

test('what was deleted after a backup does not come back with it', async () => {
  const { database, server, teacher, id, code } = await serverOn()
  const [gone, stays] = [await server.pupil(code, 'Verschwunden'), await server.pupil(code, 'Geblieben')]
  await save(gone.browser, 0)
  await save(stays.browser, 0)
  const copy = await backedUp(database)
  await teacher.delete(`/classes/${id}/pupils/${gone.id}`)
  await database.close()
  expect(await copy.restore()).toMatchObject({ kind: 'restored', deletionsUnknown: false })
  const again = await open()
  const rows = await again.db.selectFrom('pupil').select('nickname').execute()
  expect(rows).toEqual([{ nickname: 'Geblieben' }])
  await again.close()
})

test('a teacher who was deleted after a backup stays deleted when it is restored', async () => {
  const { database, server, teacher } = await serverOn()
  const gone = await server.furtherTeacher(teacher, 'k.gone')
  const { id } = await server.openClass(gone)
  const copy = await backedUp(database)
  await gone.delete(`/classes/${id}`, { name: '5b' })
  await gone.delete('/teachers/me', { password: 'ein anderer satz' })
  await database.close()
  await copy.restore()
  const again = await open()
  const rows = await again.db.selectFrom('teacher').select('username').execute()
  expect(rows).toEqual([{ username: 'm.weber' }])
  await again.close()
})

test('a deletion whose line was cut off spoils no other', () => {
  bury(folder, { kind: 'class', id: 'one' })
  appendFileSync(join(folder, 'deleted.jsonl'), '{"kind":"cla')
  bury(folder, { kind: 'pupil', id: 'two' })
  expect(buriedIn(folder)).toEqual([
    { kind: 'class', id: 'one' },
    { kind: 'pupil', id: 'two' },
  ])
})

test('a broken database is set aside unchanged, and the last backup is offered', async () => {
  const database = await open()
  const stored = { ...storedIn(folder, database), day: '2026-11-23' }
  await nightlyBackup(stored)
  const phrase = await phraseOf(database, stored.secret)
  await database.close()
  const bytes = readFileSync(databaseIn(folder))
  bytes.fill(0xff, 4096 * 2, 4096 * 6)
  writeFileSync(databaseIn(folder), bytes)
  const opened = await openDataFolder(folder, stored)
  const last = join(folder, 'backups', '000001-2026-11-23.age')
  expect(opened).toMatchObject({ kind: 'broken', lastBackup: last })
  expect(readFileSync((opened as { aside: string }).aside).equals(bytes)).toBe(true)
  await restore(folder, last, { day: today, phrase })
  const again = await open()
  expect(await again.db.selectFrom('class').selectAll().execute()).toEqual([])
  await again.close()
})

test('what is no backup replaces nothing', async () => {
  const { database } = await serverOn()
  await database.close()
  const before = readFileSync(databaseIn(folder))
  writeFileSync(join(folder, 'holiday.jpg'), 'x'.repeat(9000))
  for (const name of ['holiday.jpg', 'missing.db'])
    expect(await restore(folder, join(folder, name), { day: today, phrase: null })).toEqual({
      kind: 'notABackup',
    })
  expect(readFileSync(databaseIn(folder)).equals(before)).toBe(true)
})
