import SqliteFile from 'better-sqlite3'
import { Kysely } from 'kysely'
import { answersBeside, openAnswersFile } from './answers/sqlite.ts'
import type { Database } from './database.ts'
import { busyTimeout, Dialect } from './sqlite-dialect.ts'
import type { Tables } from './tables.ts'

/** Pages of the journal after which a commit puts it away itself, 16 MB: `checkpoint` comes long before. */
const mostPages = 4000

/** Of the file's pages so many kB stay in memory, in place of 16 MB that fill up in a lesson: a save reads few of them twice. */
const cache = 4000

const mostStatements = 200

/** Compiles a query once: a save asks the same dozen every time. */
function keepStatements(sqlite: SqliteFile.Database): void {
  const compile = sqlite.prepare.bind(sqlite)
  const known = new Map<string, SqliteFile.Statement>()
  const prepare = (query: string): SqliteFile.Statement => {
    const found = known.get(query)
    if (found) return found
    // Queries with lists have many forms; the oldest goes.
    if (known.size >= mostStatements) known.delete(known.keys().next().value!)
    const statement = compile(query)
    known.set(query, statement)
    return statement
  }
  Object.assign(sqlite, { prepare })
}

function answersOf(sqlite: SqliteFile.Database, file: string) {
  try {
    return openAnswersFile(answersBeside(file))
  } catch (error) {
    sqlite.close()
    throw error
  }
}

/**
 * One file, one connection, so one writer. A save is acknowledged once it is on the disk (`synchronous=FULL`).
 * @param file path, or `:memory:`
 * @throws SqliteError with its code where the file cannot be opened or is none
 */
export function openSqlite(file: string): Database {
  const sqlite = new SqliteFile(file)
  try {
    sqlite.pragma(`busy_timeout = ${busyTimeout}`)
    sqlite.pragma('journal_mode = WAL')
    sqlite.pragma('synchronous = FULL')
    sqlite.pragma(`wal_autocheckpoint = ${mostPages}`)
    sqlite.pragma(`cache_size = -${cache}`)
    sqlite.pragma('foreign_keys = ON')
    // What was deleted is not to be found in the file's free pages.
    sqlite.pragma('secure_delete = ON')
  } catch (error) {
    sqlite.close()
    throw error
  }
  keepStatements(sqlite)
  const answers = answersOf(sqlite, file)
  const db = new Kysely<Tables>({ dialect: new Dialect(sqlite) })
  return {
    kind: 'sqlite',
    db,
    answers,
    backup: async (copy) => void (await sqlite.backup(copy)),
    checkpoint: () => void sqlite.pragma('wal_checkpoint(PASSIVE)'),
    emptyJournal: () => void sqlite.pragma('wal_checkpoint(TRUNCATE)'),
    close: async () => {
      await answers.close()
      await db.destroy()
    },
  }
}
