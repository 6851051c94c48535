import { Kysely, PostgresDialect } from 'kysely'
import pg from 'pg'
import { openAnswersOn } from './answers/postgres.ts'
import type { Database } from './database.ts'
import { asNumbers } from './postgres-numbers.ts'
import type { Tables } from './tables.ts'

/** @param address `postgres://user:password@host/database` */
export function openPostgres(address: string): Database {
  const pool = new pg.Pool({
    connectionString: address,
    types: asNumbers,
    max: 10,
    connectionTimeoutMillis: 5000,
  })
  // A connection that breaks while nobody uses it: the next query opens another one.
  pool.on('error', () => {})
  const db = new Kysely<Tables>({ dialect: new PostgresDialect({ pool }) })
  const answers = openAnswersOn(address)
  const close = async () => {
    await answers.close()
    await db.destroy()
  }
  return { kind: 'postgres', db, answers, backup: null, checkpoint: null, close }
}
