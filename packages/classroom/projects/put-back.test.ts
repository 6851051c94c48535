// Each way in which a database is put back to an earlier state is noticed by the marks that devices send.
import { cpSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { sql } from 'kysely'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import { migrate } from '../database/migrate.ts'
import { openPostgres } from '../database/postgres.ts'
import { backup } from '../hosting/backups.ts'
import { databaseIn, secretIn } from '../hosting/data-folder.ts'
import { phraseOf } from '../hosting/phrase-store.ts'
import { restore } from '../hosting/restore.ts'
import { openedIn } from '../testing/databases.ts'
import { noPostgres, startPostgres, type Postgres } from '../testing/postgres.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'

const day = '2026-11-24'

interface Way {
  readonly open: () => Promise<Database>
  /** Stores the current state. @returns puts it back while the database is closed */
  readonly store: (database: Database) => Promise<() => Promise<void>>
}

async function noticesPuttingBack({ open, store }: Way) {
  let database = await open()
  const first = new Server(database, quickAccounts(database))
  const { code } = await first.openClass(await first.firstTeacher())
  const pupil = await first.pupil(code, 'Fuchs')
  const save = async (server: Server, base: number, project = 'project-1') => {
    const browser = server.browser()
    for (const [name, value] of pupil.browser.cookies) browser.cookies.set(name, value)
    const path = `/projects/${project}?base=${base}&save=save-${project}-${base}`
    const { status, body } = await browser.put(path, projectText(`${project} ${base}`))
    expect(status).toBe(200)
    const { mark } = body as { mark: string }
    const list = async (seen: string) =>
      (await browser.get(`/projects?mark=${encodeURIComponent(seen)}`)).body as object
    return { mark, list }
  }
  const before = await save(first, 0)
  const putBack = await store(database)
  const { mark: lost } = await save(first, 1)
  const { mark: alsoLost } = await save(first, 0, 'project-2')
  await database.close()

  await putBack()
  database = await open()
  const second = new Server(database, quickAccounts(database))
  // A save of another device: its mark has the number of the lost one.
  const { list } = await save(second, 1)
  for (const mark of [lost, alsoLost]) expect(await list(mark)).toMatchObject({ known: false })
  expect(await list(before.mark)).toMatchObject({ known: true, projects: [{ id: 'project-1', revision: 2 }] })
  await database.close()
}

describe('a data folder', () => {
  let folder: string
  beforeAll(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-put-back-'))))
  afterAll(() => rmSync(folder, { recursive: true, force: true }))

  const openIn = (name: string) => () => openedIn(join(folder, name))

  test('is put back from a backup', () =>
    noticesPuttingBack({
      open: openIn('restored'),
      store: async (database) => {
        const [own, file] = [join(folder, 'restored'), join(folder, 'backup.age')]
        const secret = secretIn(own)
        await backup({ database, secret, folder: own, day }, file)
        const phrase = await phraseOf(database, secret)
        return async () =>
          expect(await restore(own, file, { day, phrase })).toMatchObject({ kind: 'restored' })
      },
    }))

  test('is put back from a copy of the folder', () =>
    noticesPuttingBack({
      open: openIn('copied'),
      store: (database) => {
        database.checkpoint?.()
        const [own, copy] = [join(folder, 'copied'), join(folder, 'copy')]
        cpSync(own, copy, { recursive: true })
        return Promise.resolve(() => {
          for (const end of ['', '-wal', '-shm']) rmSync(`${databaseIn(own)}${end}`, { force: true })
          return Promise.resolve(cpSync(copy, own, { recursive: true }))
        })
      },
    }))
})

describe.skipIf(noPostgres() !== null)('PostgreSQL', () => {
  let postgres: Postgres
  beforeAll(async () => void (postgres = await startPostgres()))
  afterAll(() => postgres.stop())

  const openAt = (address: () => string) => async () => {
    const database = openPostgres(address())
    await migrate(database)
    return database
  }

  test('is put back from a dump', async () => {
    let address = await postgres.newDatabase()
    await noticesPuttingBack({
      open: openAt(() => address),
      store: async () => {
        const copy = await postgres.newDatabase()
        const dumped = await dump(address)
        return async () => {
          await load(copy, dumped)
          address = copy
        }
      },
    })
  })

  test('is put back by a reset of its machine or a failover to a late replica', async () => {
    const address = await postgres.newDatabase()
    await noticesPuttingBack({ open: openAt(() => address), store: () => postgres.snapshot() })
  })
})

const tables = [
  'teacher',
  'account',
  'teacherSession',
  'class',
  'pupil',
  'pupilSession',
  'project',
  'version',
  'answered',
  'mark',
] as const

/** All rows of a database, as a dump has them. */
async function dump(address: string) {
  const database = openPostgres(address)
  const rows = []
  for (const table of tables)
    rows.push(
      (
        await sql<{
          row: string
        }>`select row_to_json(one)::text as row from ${sql.table(table)} as one`.execute(database.db)
      ).rows,
    )
  await database.close()
  return rows
}

async function load(address: string, dumped: Awaited<ReturnType<typeof dump>>) {
  const database = openPostgres(address)
  await migrate(database)
  for (const [at, table] of tables.entries())
    for (const { row } of dumped[at]!)
      await sql`insert into ${sql.table(table)} select * from json_populate_record(null::${sql.table(table)}, ${row}::json)`.execute(
        database.db,
      )
  await database.close()
}
