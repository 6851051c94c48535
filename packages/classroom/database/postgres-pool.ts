import pg from 'pg'
import { asNumbers } from './postgres-numbers.ts'

/** Limits in ms. */
export interface Patience {
  /** For a connection, or for one that is free. */
  readonly connecting: number
  /** For a statement in the database, which ends it then. */
  readonly statement: number
  /** For any answer: a database that is frozen does not end its statements. */
  readonly reply: number
}

/** Pages wait 30 s for an answer: they are answered 503 before that. */
const usual: Patience = { connecting: 5000, statement: 15_000, reply: 20_000 }

/**
 * Connections that survive each fault of their database: a crash, a failover, a freeze.
 * @param max connections at once
 */
export function openPool(address: string, max: number, patience: Patience = usual): pg.Pool {
  const pool = new pg.Pool({
    ...{ connectionString: address, types: asNumbers, max },
    ...{ keepAlive: true, keepAliveInitialDelayMillis: 10_000 },
    connectionTimeoutMillis: patience.connecting,
    statement_timeout: patience.statement,
    query_timeout: patience.reply,
  })
  // The pool reports errors of idle connections only. Without a listener an error of one that is in use, between two queries of
  // a transaction, would end the process; the transaction's next query rejects anyway.
  pool.on('error', () => {})
  pool.on('connect', (client) => void client.on('error', () => {}))
  return pool
}
