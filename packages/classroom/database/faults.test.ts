import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import SqliteFile from 'better-sqlite3'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { projectText } from '../testing/projects.ts'
import { testOnDisk } from '../testing/small-disk.ts'
import { Server } from '../testing/world.ts'
import { migrate } from './migrate.ts'
import { openSqlite } from './sqlite.ts'
import type { Database } from './database.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-fault-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

async function classOn(file: string) {
  const database: Database = openSqlite(file)
  await migrate(database)
  const server = new Server(database)
  const teacher = await server.firstTeacher()
  const { code } = await server.openClass(teacher)
  const { browser } = await server.pupil(code, 'Fuchs')
  const save = (base: number, text = projectText(`${base}`)) =>
    browser.put(`/projects/project-1?base=${base}&save=save-on-${base}`, text)
  return { database, server, browser, save }
}

test('while another program holds the file a save is refused as busy, and taken afterwards', async () => {
  const file = join(folder, 'class.db')
  const { database, save } = await classOn(file)
  await save(0)
  const other = new SqliteFile(file)
  other.exec('begin immediate')
  expect(await save(1)).toMatchObject({ status: 503, body: { error: 'busy' } })
  other.exec('rollback')
  other.close()
  expect(await save(1)).toMatchObject({ status: 200, body: { revision: 2 } })
  await database.close()
})

test('a file that cannot be written says so, and what is in it can be read', async () => {
  const file = join(folder, 'class.db')
  const { database, browser, save, server } = await classOn(file)
  await save(0)
  await database.close()
  const sqlite = new SqliteFile(file, { readonly: true })
  const { Kysely, SqliteDialect } = await import('kysely')
  const db = new Kysely<never>({ dialect: new SqliteDialect({ database: sqlite }) })
  const readOnly = new Server({ ...database, db })
  readOnly.now = server.now
  const child = readOnly.browser()
  for (const [name, value] of browser.cookies) child.cookies.set(name, value)
  const answer = await child.put('/projects/project-1?base=1&save=save-on-1', projectText('1'))
  expect(answer).toMatchObject({ status: 503, body: { error: 'notWritable' } })
  expect((await child.get('/projects/project-1')).body).toMatchObject({ revision: 1 })
  await db.destroy()
})

test('a file that is no database is refused with its code', () => {
  const file = join(folder, 'class.db')
  writeFileSync(file, 'x'.repeat(5000))
  expect(() => openSqlite(file)).toThrow(expect.objectContaining({ code: 'SQLITE_NOTADB' }))
  // It is left as it was, so that its content can still be rescued.
  expect(readFileSync(file, 'utf8')).toBe('x'.repeat(5000))
})

testOnDisk(
  'on a full disk a save is refused in words, nothing acknowledged is lost, and with room again it goes on',
  6,
  async (disk) => {
    const { database, browser, save } = await classOn(join(disk, 'class.db'))
    writeFileSync(join(disk, 'ballast'), Buffer.alloc(1_500_000))
    let revision = 0
    let refused: { status: number; body: unknown } | null = null
    while (!refused) {
      const answer = await save(revision, projectText(`${revision} ${'x'.repeat(15_000)}`))
      if (answer.status === 200) revision++
      else refused = answer
    }
    expect(refused).toMatchObject({ status: 507, body: { error: 'diskFull' } })
    expect((await browser.get('/projects/project-1')).body).toMatchObject({ revision })
    rmSync(join(disk, 'ballast'))
    expect(await save(revision)).toMatchObject({ status: 200, body: { revision: revision + 1 } })
    await database.close()
  },
)
