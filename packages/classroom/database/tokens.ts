import { sql, type Kysely } from 'kysely'
import type { Kind } from './database.ts'

/**
 * Pupils who were given their token for a form. Rows hold no time, and in a file the table is the tree of its keys
 * (WITHOUT ROWID): a number of the row would reveal the order in which they came.
 */
export const tokens = (kind: Kind) => ({
  async up({ schema }: Kysely<unknown>): Promise<void> {
    const table = schema
      .createTable('token')
      .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
      .addColumn('form', 'text', (column) => column.notNull())
      .addColumn('blinded', 'text')
      .addColumn('again', 'integer', (column) => column.notNull().defaultTo(0))
      .addPrimaryKeyConstraint('tokenKey', ['pupil', 'form'])
    await (kind === 'sqlite' ? table.modifyEnd(sql`without rowid`) : table).execute()
  },
})
