import type { Kysely } from 'kysely'

/**
 * One mark for each committed change of a pupil's projects. A device remembers the newest that it saw: a mark that the
 * database does not have means that the database was put back to an earlier state.
 */
export const marks = {
  async up({ schema }: Kysely<unknown>): Promise<void> {
    await schema
      .alterTable('pupil')
      .addColumn('changes', 'integer', (column) => column.notNull().defaultTo(0))
      .execute()
    await schema
      .createTable('mark')
      .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
      .addColumn('number', 'integer', (column) => column.notNull())
      .addColumn('random', 'text', (column) => column.notNull())
      .addPrimaryKeyConstraint('markKey', ['pupil', 'number'])
      .execute()
  },
}
