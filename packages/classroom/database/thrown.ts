import type { Kysely } from 'kysely'

/** Projects that pupils have thrown away: their other devices throw them away too. */
export const thrown = {
  up: ({ schema }: Kysely<unknown>): Promise<void> =>
    schema
      .createTable('thrown')
      .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
      .addColumn('project', 'text', (column) => column.notNull())
      .addColumn('revision', 'integer', (column) => column.notNull())
      .addPrimaryKeyConstraint('thrownKey', ['pupil', 'project'])
      .execute(),
}
