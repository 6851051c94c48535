import { basename, dirname, join } from 'node:path'
import SqliteFile from 'better-sqlite3'
import { Kysely, sql } from 'kysely'
import { busyTimeout, Dialect } from '../sqlite-dialect.ts'
import type { AnswersDatabase } from './database.ts'
import type { AnswerTables } from './tables.ts'

/** The file of answers beside that of the lab. */
export const answersBeside = (file: string): string => {
  if (file === ':memory:') return file
  const name = basename(file, '.db')
  return join(dirname(file), name === 'botgarten' ? 'answers.db' : `${name}.answers.db`)
}

/**
 * No journal that goes on (WAL) holds the order in which answers came, and no free page what was there before.
 * @param file path, or `:memory:`
 * @throws SqliteError with its code where the file cannot be opened or is none
 */
export function openAnswersFile(file: string): AnswersDatabase {
  const sqlite = new SqliteFile(file)
  try {
    sqlite.pragma(`busy_timeout = ${busyTimeout}`)
    sqlite.pragma('journal_mode = DELETE')
    sqlite.pragma('synchronous = FULL')
    sqlite.pragma('foreign_keys = ON')
    sqlite.pragma('secure_delete = ON')
    sqlite.pragma('temp_store = MEMORY')
  } catch (error) {
    sqlite.close()
    throw error
  }
  const db = new Kysely<AnswerTables>({ dialect: new Dialect(sqlite) })
  return {
    ...{ db, locks: false, schema: () => Promise.resolve(null) },
    vacuum: async () => void (await sql`vacuum`.execute(db)),
    copy: async (copy) => void (await sql`vacuum into ${copy}`.execute(db)),
    close: () => db.destroy(),
  }
}
