import type { Kysely, Transaction } from 'kysely'
import type { AnswersDatabase } from './answers/database.ts'
import type { Tables } from './tables.ts'

export type Kind = 'sqlite' | 'postgres'

export interface Database {
  readonly kind: Kind
  readonly db: Kysely<Tables>
  /** What was answered to questionnaires: beside the lab's database and never in it. */
  readonly answers: AnswersDatabase
  /** Copies the whole database into a file while it is in use; null where its own tools do that (pg_dump). */
  readonly backup: ((file: string) => Promise<void>) | null
  /** Moves what was committed from the journal into the file, where the database has one; commits go without it. */
  readonly checkpoint: (() => void) | null
  /** Empties the journal, if there is one: it has earlier states of rows that were deleted. */
  readonly emptyJournal: () => void
  close(): Promise<void>
}

/** A connection or a transaction of it. */
export type Db = Kysely<Tables> | Transaction<Tables>
