import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, beforeAll, describe } from 'vitest'
import type { Database } from '../database/database.ts'
import { migrate } from '../database/migrate.ts'
import { openPostgres } from '../database/postgres.ts'
import { openSqlite } from '../database/sqlite.ts'
import { openDataFolder, secretIn } from '../hosting/data-folder.ts'
import { noPostgres, startPostgres, type Postgres } from './postgres.ts'

/** Makes a new database with all tables. */
export type Fresh = () => Promise<Database>

/** The database of a data folder. @throws if it is broken */
export async function openedIn(folder: string): Promise<Database> {
  const opened = await openDataFolder(folder, { secret: secretIn(folder), day: '2026-11-24' })
  if (opened.kind === 'broken') throw new Error('The database is broken.')
  return opened.database
}

/** Runs the same tests on both databases. */
export function onBothDatabases(tests: (fresh: Fresh) => void): void {
  describe('on SQLite', () => onSqlite(tests))
  const why = noPostgres()
  describe.skipIf(why !== null)(`on PostgreSQL${why ? ` (skipped: ${why})` : ''}`, () => onPostgres(tests))
}

function onSqlite(tests: (fresh: Fresh) => void) {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-sqlite-'))
  const opened: Database[] = []
  afterAll(async () => {
    for (const one of opened) await one.close()
    rmSync(folder, { recursive: true, force: true })
  })
  tests(async () => {
    const database = openSqlite(join(folder, `${opened.length}.db`))
    opened.push(database)
    await migrate(database)
    return database
  })
}

function onPostgres(tests: (fresh: Fresh) => void) {
  let server: Postgres
  const opened: Database[] = []
  beforeAll(async () => {
    server = await startPostgres()
  })
  afterAll(async () => {
    for (const one of opened) await one.close()
    await server.stop()
  })
  tests(async () => {
    const database = openPostgres(await server.newDatabase())
    opened.push(database)
    await migrate(database)
    return database
  })
}
