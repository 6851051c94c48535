import { sql, type Kysely } from 'kysely'

/**
 * The first tables of answers. In a file a table is the tree of its keys alone (WITHOUT ROWID): a number that counts up with
 * every row would say in which order they came.
 * @param inFile SQLite
 */
export const first = (inFile: boolean) => ({
  async up({ schema }: Kysely<unknown>): Promise<void> {
    const tables = [
      schema
        .createTable('asking')
        .addColumn('key', 'text', (column) => column.primaryKey().notNull())
        .addColumn('class', 'text', (column) => column.notNull())
        .addColumn('form', 'text', (column) => column.notNull())
        .addColumn('document', 'text', (column) => column.notNull())
        .addColumn('grade', 'integer', (column) => column.notNull())
        .addColumn('day', 'text', (column) => column.notNull())
        .addColumn('state', 'text', (column) => column.notNull())
        .addColumn('closesAt', 'bigint')
        .addUniqueConstraint('askedOnce', ['class', 'form']),
      schema
        .createTable('answer')
        .addColumn('asking', 'text', (column) =>
          column.notNull().references('asking.key').onDelete('cascade'),
        )
        .addColumn('id', 'text', (column) => column.notNull())
        .addColumn('code', 'text')
        .addColumn('chosen', 'text', (column) => column.notNull())
        .addPrimaryKeyConstraint('answerKey', ['asking', 'id']),
      schema
        .createTable('paper')
        .addColumn('asking', 'text', (column) =>
          column.notNull().references('asking.key').onDelete('cascade'),
        )
        .addColumn('id', 'text', (column) => column.notNull())
        .addColumn('document', 'text', (column) => column.notNull())
        .addPrimaryKeyConstraint('paperKey', ['asking', 'id']),
      schema
        .createTable('published')
        .addColumn('class', 'text', (column) => column.primaryKey().notNull())
        .addColumn('document', 'text', (column) => column.notNull()),
    ]
    for (const table of tables) await (inFile ? table.modifyEnd(sql`without rowid`) : table).execute()
  },
})
