import { DEFAULT_MIGRATION_TABLE, Migrator, sql } from 'kysely'
import type { Database } from './database.ts'
import { migrateAnswers } from './answers/migrate.ts'
import { days } from './days.ts'
import { first } from './first.ts'
import { gallery } from './gallery.ts'
import { lessons } from './lessons.ts'
import { limits } from './limits.ts'
import { live } from './live.ts'
import { marks } from './marks.ts'
import { thrown } from './thrown.ts'
import { together, togetherSwitch } from './together.ts'
import { tokens } from './tokens.ts'
import { versions } from './versions.ts'
import { wifi } from './wifi.ts'

/** Kysely takes the steps in the order of their names: `step-` comes after the dates of the first ones. */
export const migrations = ({ kind }: Pick<Database, 'kind'>) => ({
  '2026-11-first': first(kind),
  '2026-11-live': live,
  '2026-11-thrown': thrown,
  '2026-11-wifi': wifi,
  '2026-12-gallery': gallery,
  '2026-12-together': together,
  '2026-12-together-switch': togetherSwitch,
  'step-008-marks': marks,
  'step-009-lessons': lessons,
  'step-011-tokens': tokens(kind),
  'step-012-days': days,
  'step-015-limits': limits,
  'step-016-versions': versions,
})

const migrator = (database: Database) =>
  new Migrator({
    db: database.db,
    provider: { getMigrations: () => Promise.resolve(migrations(database)) },
  })

/** A later version of the program has written this database. */
export class NewerData extends Error {
  override readonly name = 'NewerData'
}

/** @throws NewerData if this database has taken steps that this version does not know */
export async function refuseNewer({ db, kind }: Database): Promise<void> {
  const known = Object.keys(migrations({ kind }))
  // A database without the table has taken no step at all.
  const tables = await db.introspection.getTables({ withInternalKyselyTables: true })
  if (!tables.some(({ name }) => name === DEFAULT_MIGRATION_TABLE)) return
  const { rows } = await sql<{
    name: string
  }>`select name from ${sql.table(DEFAULT_MIGRATION_TABLE)}`.execute(db)
  const unknown = rows.map(({ name }) => name).filter((name) => !known.includes(name))
  if (unknown.length > 0) throw new NewerData(`Unknown steps: ${unknown.join(', ')}`)
}

/** Has an earlier version written this database? Then a copy is made before its tables change. */
export async function needsMigration(database: Database): Promise<boolean> {
  const steps = await migrator(database).getMigrations()
  const taken = steps.filter(({ executedAt }) => executedAt !== undefined).length
  return taken > 0 && taken < steps.length
}

/** Takes the steps that are missing, forward only, under the migrator's lock. @throws the error of the step that failed */
export async function migrate(database: Database): Promise<void> {
  await refuseNewer(database)
  await migrateAnswers(database.answers)
  const { error } = await migrator(database).migrateToLatest()
  if (error !== undefined) throw error instanceof Error ? error : new Error('A migration failed.')
}
