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
import { openedIn } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import { backup, lastBackup, nightlyBackup } from './backups.ts'
import { databaseIn, openDataFolder, secretIn } from './data-folder.ts'
import { restore } from './restore.ts'
import { bury, buriedIn } from './tombstones.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-data-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

const open = () => openedIn(folder)

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
  const file = join(folder, 'copy.db')
  await Promise.all([backup(database, file), save(child.browser, 5), save(child.browser, 6)])
  await database.close()
  expect(await restore(folder, file)).toMatchObject({ kind: 'restored' })
  const again = await open()
  const rows = await again.db.selectFrom('project').select('revision').execute()
  expect(rows[0]!.revision).toBeGreaterThanOrEqual(5)
  await again.close()
})

test('one copy a night is made, and seven are kept', async () => {
  const database = await open()
  for (let day = 10; day < 20; day++) await nightlyBackup(folder, database, `2026-11-${day}`)
  expect(readdirSync(join(folder, 'backups')).toSorted()).toEqual(
    Array.from({ length: 7 }, (_, at) => [`2026-11-${13 + at}.answers.db`, `2026-11-${13 + at}.db`]).flat(),
  )
  expect(lastBackup(folder)).toBe(join(folder, 'backups', '2026-11-19.db'))
  await database.close()
})

test('what was deleted after a backup does not come back with it', async () => {
  const { database, server, teacher, id, code } = await serverOn()
  const [gone, stays] = [await server.pupil(code, 'Verschwunden'), await server.pupil(code, 'Geblieben')]
  await save(gone.browser, 0)
  await save(stays.browser, 0)
  const file = join(folder, 'copy.db')
  await backup(database, file)
  await teacher.delete(`/classes/${id}/pupils/${gone.id}`)
  await database.close()
  await restore(folder, file)
  const again = await open()
  const rows = await again.db.selectFrom('pupil').select('nickname').execute()
  expect(rows).toEqual([{ nickname: 'Geblieben' }])
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
  await nightlyBackup(folder, database, '2026-11-23')
  await database.close()
  const bytes = readFileSync(databaseIn(folder))
  bytes.fill(0xff, 4096 * 2, 4096 * 6)
  writeFileSync(databaseIn(folder), bytes)
  const opened = await openDataFolder(folder)
  expect(opened).toMatchObject({ kind: 'broken', lastBackup: join(folder, 'backups', '2026-11-23.db') })
  expect(readFileSync((opened as { aside: string }).aside).equals(bytes)).toBe(true)
  await restore(folder, lastBackup(folder)!)
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
    expect(await restore(folder, join(folder, name))).toEqual({ kind: 'notABackup' })
  expect(readFileSync(databaseIn(folder)).equals(before)).toBe(true)
})
