import type { Kysely } from 'kysely'

/** The gallery of a class and its hearts, and what pupils ask each other. */
export const gallery = {
  async up({ schema }: Kysely<unknown>): Promise<void> {
    const columns = [
      ['gallery', 1],
      ['asking', 0],
    ] as const
    for (const [column, value] of columns)
      await schema
        .alterTable('class')
        .addColumn(column, 'integer', (one) => one.notNull().defaultTo(value))
        .execute()
    for (const table of tables(schema)) await table.execute()
    for (const [table, column] of indexes)
      await schema.createIndex(`${table}By${column}`).on(table).column(column).execute()
  },
}

const indexes = [
  ['shared', 'class'],
  ['sharedAsset', 'class'],
  ['heart', 'pupil'],
  ['peerQuestion', 'to'],
] as const

const tables = (schema: Kysely<unknown>['schema']) => [
  schema
    .createTable('shared')
    .addColumn('id', 'text', (column) => column.primaryKey())
    .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
    .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addColumn('sent', 'text', (column) => column.notNull())
    .addColumn('title', 'text', (column) => column.notNull())
    .addColumn('card', 'text')
    .addColumn('at', 'bigint', (column) => column.notNull())
    .addColumn('bytes', 'integer', (column) => column.notNull())
    .addColumn('brain', 'integer', (column) => column.notNull())
    .addColumn('world', 'text', (column) => column.notNull())
    .addColumn('chain', 'text', (column) => column.notNull())
    .addColumn('hidden', 'integer', (column) => column.notNull())
    .addColumn('waiting', 'integer', (column) => column.notNull())
    // Last: a list is read without walking over it.
    .addColumn('document', 'text', (column) => column.notNull())
    .addUniqueConstraint('sharedOnce', ['pupil', 'sent']),
  schema
    .createTable('sharedAsset')
    .addColumn('shared', 'text', (column) => column.notNull().references('shared.id').onDelete('cascade'))
    .addColumn('class', 'text', (column) => column.notNull())
    .addColumn('name', 'text', (column) => column.notNull())
    .addColumn('hash', 'text', (column) => column.notNull())
    .addPrimaryKeyConstraint('sharedAssetKey', ['shared', 'name']),
  schema
    .createTable('heart')
    .addColumn('shared', 'text', (column) => column.notNull().references('shared.id').onDelete('cascade'))
    .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addPrimaryKeyConstraint('heartKey', ['shared', 'pupil']),
  schema
    .createTable('peerQuestion')
    .addColumn('pupil', 'text', (column) => column.primaryKey().references('pupil.id').onDelete('cascade'))
    .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
    .addColumn('to', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addColumn('card', 'text', (column) => column.notNull())
    .addColumn('at', 'bigint', (column) => column.notNull())
    .addColumn('answer', 'text'),
]
