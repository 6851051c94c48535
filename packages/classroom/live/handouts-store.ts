import type { Insertable } from 'kysely'
import type { Db } from '../database/database.ts'
import type { HandoutTable } from '../database/tables.ts'

/** Adds a hint or a program for these pupils. */
export async function addHandout(
  db: Db,
  row: Insertable<HandoutTable>,
  pupils: readonly string[],
): Promise<void> {
  await db.insertInto('handout').values(row).execute()
  await db
    .insertInto('handoutTo')
    .values(pupils.map((pupil) => ({ handout: row.id, pupil })))
    .execute()
}

/** What a pupil has been sent and has not put away, the oldest first; documents are left out. */
export const handoutsOf = (db: Db, pupil: string) =>
  db
    .selectFrom('handoutTo')
    .innerJoin('handout', 'handout.id', 'handoutTo.handout')
    .select(['id', 'kind', 'card', 'hint', 'text', 'at'])
    .where('pupil', '=', pupil)
    .orderBy('at')
    .orderBy('id')
    .execute()

/** Hints and programs that a pupil was sent and has not put away, with their documents. */
export async function* sentTo(db: Db, pupil: string) {
  for (const handout of await handoutsOf(db, pupil)) {
    const document = await documentOf(db, pupil, handout.id)
    yield { ...handout, project: document ? (JSON.parse(document) as unknown) : null }
  }
}

/** The project of a program; undefined where this pupil was not sent it, null where it is a card's own start. */
export async function documentOf(db: Db, pupil: string, handout: string): Promise<string | null | undefined> {
  const row = await db
    .selectFrom('handoutTo')
    .innerJoin('handout', 'handout.id', 'handoutTo.handout')
    .select('document')
    .where('pupil', '=', pupil)
    .where('id', '=', handout)
    .executeTakeFirst()
  return row?.document
}

/** Puts one away; what nobody has any more is deleted. @returns false where there is none */
export async function putAway(db: Db, pupil: string, handout: string): Promise<boolean> {
  const gone = await db
    .deleteFrom('handoutTo')
    .where('pupil', '=', pupil)
    .where('handout', '=', handout)
    .returning('handout')
    .executeTakeFirst()
  if (gone) await deleteUnheld(db)
  return gone !== undefined
}

/** Deletes what no pupil holds, also of pupils that were deleted. */
export async function deleteUnheld(db: Db): Promise<void> {
  await db
    .deleteFrom('handout')
    .where((row) => row('id', 'not in', row.selectFrom('handoutTo').select('handout')))
    .execute()
}
