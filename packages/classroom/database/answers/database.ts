import type { Kysely, Transaction } from 'kysely'
import type { AnswerTables } from './tables.ts'

/** The answers to questionnaires lie in a database of their own: nothing in it leads to a pupil. */
export interface AnswersDatabase {
  readonly db: Kysely<AnswerTables>
  /** Does a query that locks rows have to say so? SQLite has one writer. */
  readonly locks: boolean
  /** Where its tables lie in a PostgreSQL; null for a file. */
  readonly schema: () => Promise<string | null>
  /** Writes everything anew: where a row lies says nothing any more, and nothing of what was deleted stays. */
  readonly vacuum: () => Promise<void>
  /** Copies all of it into a file, in the order of its keys; null where the database's own tools do that. */
  readonly copy: ((file: string) => Promise<void>) | null
  close(): Promise<void>
}

/** A connection or a transaction of it. */
export type AnswersDb = Kysely<AnswerTables> | Transaction<AnswerTables>
