import type { Kysely } from 'kysely'

/** Two pupils on one program: who with whom, what they began with, and what they have done since, in order. */
export const together = {
  async up({ schema }: Kysely<unknown>): Promise<void> {
    for (const table of tables(schema)) await table.execute()
    for (const column of ['class', 'inviter', 'invited'])
      await schema.createIndex(`pairBy${column}`).on('pair').column(column).execute()
  },
}

/** Whether two of a class may work on one program: they may, until the teacher says otherwise. */
export const togetherSwitch = {
  async up({ schema }: Kysely<unknown>): Promise<void> {
    await schema
      .alterTable('class')
      .addColumn('together', 'integer', (one) => one.notNull().defaultTo(1))
      .execute()
  },
}

const tables = (schema: Kysely<unknown>['schema']) => [
  schema
    .createTable('pair')
    .addColumn('id', 'text', (column) => column.primaryKey())
    .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
    .addColumn('inviter', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addColumn('invited', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addColumn('title', 'text', (column) => column.notNull())
    .addColumn('accepted', 'integer', (column) => column.notNull())
    .addColumn('left', 'text')
    .addColumn('hand', 'text', (column) => column.notNull())
    .addColumn('length', 'integer', (column) => column.notNull())
    .addColumn('bytes', 'integer', (column) => column.notNull())
    .addColumn('ofInviter', 'integer', (column) => column.notNull())
    .addColumn('ofInvited', 'integer', (column) => column.notNull())
    .addColumn('windowEndsAt', 'bigint', (column) => column.notNull())
    .addColumn('inWindow', 'integer', (column) => column.notNull())
    .addColumn('at', 'bigint', (column) => column.notNull())
    // Last: the rest is read without walking over it.
    .addColumn('document', 'text', (column) => column.notNull()),
  schema
    .createTable('pairEntry')
    .addColumn('pair', 'text', (column) => column.notNull().references('pair.id').onDelete('cascade'))
    .addColumn('seq', 'integer', (column) => column.notNull())
    .addColumn('author', 'text', (column) => column.notNull())
    .addColumn('n', 'integer', (column) => column.notNull())
    .addColumn('base', 'integer', (column) => column.notNull())
    .addColumn('op', 'text', (column) => column.notNull())
    .addPrimaryKeyConstraint('pairEntryKey', ['pair', 'seq']),
]
