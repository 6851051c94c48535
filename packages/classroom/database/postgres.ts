import { Kysely, PostgresDialect } from 'kysely'
import { openAnswersOn } from './answers/postgres.ts'
import type { Database } from './database.ts'
import { openPool, type Patience } from './postgres-pool.ts'
import type { Tables } from './tables.ts'

/** @param address `postgres://user:password@host/database` */
export function openPostgres(address: string, patience?: Patience): Database {
  const pool = openPool(address, 10, patience)
  const db = new Kysely<Tables>({ dialect: new PostgresDialect({ pool }) })
  const answers = openAnswersOn(address)
  const close = async () => {
    await answers.close()
    await db.destroy()
  }
  return { kind: 'postgres', db, answers, backup: null, checkpoint: null, emptyJournal: () => {}, close }
}
