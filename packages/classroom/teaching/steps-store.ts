// Deletions in small transactions, for a disk with little room: SQLite writes each page that changes into its journal first.
import { sql, type RawBuilder, type SqlBool } from 'kysely'
import type { Database } from '../database/database.ts'
import type { Tombstone } from '../ports.ts'
import { unusedAssets } from '../projects/space-store.ts'
import { addTombstone } from './deleting-store.ts'

type Condition = RawBuilder<SqlBool>

/** Rows of a table that are deleted, and the column that makes them large. */
interface Part {
  readonly table: string
  readonly large: string
  readonly where: Condition
}

const is = (column: string, value: string): Condition => sql<SqlBool>`${sql.ref(column)} = ${value}`

/** Tables with large rows. The last transaction deletes the rows of the others. */
const partsOfClass = (id: string): readonly Part[] => [
  ...(['version', 'shared', 'pair', 'handout'] as const).map((table) => ({
    ...{ table, large: 'document', where: is('class', id) },
  })),
  { table: 'asset', large: 'base64', where: is('class', id) },
]

const partsOfPupil = (id: string, classId: string): readonly Part[] => [
  { table: 'version', large: 'document', where: is('pupil', id) },
  { table: 'shared', large: 'document', where: is('pupil', id) },
  {
    ...{ table: 'pair', large: 'document' },
    where: sql<SqlBool>`(${is('inviter', id)} or ${is('invited', id)})`,
  },
  { table: 'asset', large: 'base64', where: unusedAssets(classId) },
]

/** Letters of the rows that go in one step; a larger row goes alone. */
const mostInStep = 2_000_000

interface Row {
  readonly rowid: number
  readonly length: number
}

function firstFew(rows: readonly Row[]): readonly number[] {
  let sum = 0
  const few = rows.filter(({ length }, at) => (sum += length) <= mostInStep || at === 0)
  return few.map(({ rowid }) => rowid)
}

async function deletePart({ db, emptyJournal }: Database, { table, large, where }: Part): Promise<void> {
  for (;;) {
    const { rows } = await sql<Row>`select rowid, coalesce(length(${sql.ref(large)}), 0) as length
      from ${sql.table(table)} where ${where} limit 100`.execute(db)
    if (rows.length === 0) return
    await sql`delete from ${sql.table(table)} where rowid in (${sql.join(firstFew(rows))})`.execute(db)
    emptyJournal()
  }
}

/** Pupils have many small rows: saves that were answered, marks, sessions. */
async function deletePupils({ db, emptyJournal }: Database, classId: string): Promise<void> {
  for (const { id } of await db.selectFrom('pupil').select('id').where('class', '=', classId).execute()) {
    await db.deleteFrom('pupil').where('id', '=', id).execute()
    emptyJournal()
  }
}

/**
 * Deletes all large rows of a class or a pupil on SQLite, and empties the journal after each step. The database has its tombstone
 * from the first step on: a deletion that is interrupted is finished in the next night.
 */
export async function deleteInSteps(database: Database, { kind, id }: Tombstone): Promise<void> {
  const { db } = database
  await addTombstone(db, { kind, id })
  database.emptyJournal()
  if (kind === 'class') {
    for (const part of partsOfClass(id)) await deletePart(database, part)
    return deletePupils(database, id)
  }
  const pupil = await db.selectFrom('pupil').select('class').where('id', '=', id).executeTakeFirst()
  for (const part of pupil ? partsOfPupil(id, pupil.class) : []) await deletePart(database, part)
}
