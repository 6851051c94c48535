import { Kysely, PostgresDialect } from 'kysely'
import pg from 'pg'
import type { Database } from './database.ts'
import type { Tables } from './tables.ts'

const int8 = 20
const numeric = 1700
/** PostgreSQL gives wide numbers and sums as text; all of ours fit a double. */
const asNumbers = {
  getTypeParser: (id: number, format?: 'text' | 'binary'): unknown => {
    if (id === int8 || id === numeric) return Number
    const usual: unknown = pg.types.getTypeParser(id, format)
    return usual
  },
}

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
  return { kind: 'postgres', db, backup: null, checkpoint: null, close: () => db.destroy() }
}
