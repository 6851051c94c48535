import { sql, type Kysely } from 'kysely'

/**
 * Lessons of a class are counted: whether a pupil has shown the pictures within this lesson does not depend on a clock, which
 * may have been ahead when the lesson before was closed.
 */
export const lessons = {
  async up(db: Kysely<unknown>): Promise<void> {
    for (const table of ['class', 'pupilSession'])
      await db.schema
        .alterTable(table)
        .addColumn('lesson', 'integer', (column) => column.notNull().defaultTo(0))
        .execute()
    await sql`update class set lesson = 1`.execute(db)
    await sql`
      update "pupilSession" set lesson = 1
      where "provenAt" > (select "closedAt" from class where class.id = "pupilSession".class)
    `.execute(db)
  },
}
