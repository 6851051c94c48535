import { sql, type Kysely } from 'kysely'

/**
 * The key with which tokens of a form are made, and the codes that are taken in it. A form without a key was opened before there
 * were tokens.
 * @param inFile SQLite: the table is the tree of its keys, which are hashes, so that no row says when it came
 */
export const tokens = (inFile: boolean) => ({
  async up({ schema }: Kysely<unknown>): Promise<void> {
    for (const column of ['secretKey', 'publicKey'])
      await schema.alterTable('asking').addColumn(column, 'text').execute()
    const table = schema
      .createTable('code')
      .addColumn('asking', 'text', (column) => column.notNull().references('asking.key').onDelete('cascade'))
      .addColumn('code', 'text', (column) => column.notNull())
      .addColumn('owner', 'text', (column) => column.notNull())
      .addPrimaryKeyConstraint('codeKey', ['asking', 'code'])
    await (inFile ? table.modifyEnd(sql`without rowid`) : table).execute()
  },
})
