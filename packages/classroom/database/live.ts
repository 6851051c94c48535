import type { Kysely } from 'kysely'

/** What the live view stores: what is free today, hints and programs until they are put away, results, substitutes. */
export const live = {
  async up({ schema }: Kysely<unknown>): Promise<void> {
    await schema.alterTable('class').addColumn('cards', 'text').execute()
    await schema.alterTable('class').addColumn('level', 'text').execute()
    for (const table of tables(schema)) await table.execute()
    for (const [table, column] of indexes)
      await schema.createIndex(`${table}By${column}`).on(table).column(column).execute()
  },
}

const indexes = [
  ['handout', 'class'],
  ['handoutTo', 'pupil'],
  ['result', 'class'],
  ['substitute', 'class'],
] as const

const tables = (schema: Kysely<unknown>['schema']) => [
  schema
    .createTable('handout')
    .addColumn('id', 'text', (column) => column.primaryKey())
    .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
    .addColumn('kind', 'text', (column) => column.notNull())
    .addColumn('card', 'text')
    .addColumn('hint', 'integer')
    .addColumn('text', 'text')
    .addColumn('document', 'text')
    .addColumn('at', 'bigint', (column) => column.notNull()),
  schema
    .createTable('handoutTo')
    .addColumn('handout', 'text', (column) => column.notNull().references('handout.id').onDelete('cascade'))
    .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addPrimaryKeyConstraint('handoutToKey', ['handout', 'pupil']),
  schema
    .createTable('result')
    .addColumn('pupil', 'text', (column) => column.notNull().references('pupil.id').onDelete('cascade'))
    .addColumn('card', 'text', (column) => column.notNull())
    .addColumn('class', 'text', (column) => column.notNull())
    .addColumn('done', 'integer', (column) => column.notNull())
    .addPrimaryKeyConstraint('resultKey', ['pupil', 'card']),
  schema
    .createTable('substitute')
    .addColumn('tokenHash', 'text', (column) => column.primaryKey())
    .addColumn('class', 'text', (column) => column.notNull().references('class.id').onDelete('cascade'))
    .addColumn('day', 'text', (column) => column.notNull()),
]
