import type { Kysely } from 'kysely'

/** The Wi-Fi of the room that a teacher's classes meet in: it stands on the projector page. */
export const wifi = {
  up: ({ schema }: Kysely<unknown>): Promise<void> =>
    schema
      .createTable('wifi')
      .addColumn('teacher', 'text', (column) =>
        column.primaryKey().references('teacher.id').onDelete('cascade'),
      )
      .addColumn('name', 'text', (column) => column.notNull())
      .addColumn('password', 'text', (column) => column.notNull())
      .execute(),
}
