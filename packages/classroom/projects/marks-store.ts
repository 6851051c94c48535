// By its last mark a device finds out whether the class still has everything that the device saw: a database that was restored
// to an earlier state (from a backup, a copied folder, a late replica) does not have the later marks.
import type { Db } from '../database/database.ts'

/** A mark as devices store it: its number, and random letters, so that no mark is made twice after a restore. */
const textOf = ({ number, random }: { readonly number: number; readonly random: string }) =>
  `${number}.${random}`

/**
 * Adds a mark for a change of a pupil's projects, inside the transaction of the change. Of two changes at once one waits
 * for the other here.
 * @param random a new token
 */
export async function renewMark(db: Db, pupil: string, random: string): Promise<string> {
  const { changes: number } = await db
    .updateTable('pupil')
    .set((row) => ({ changes: row('changes', '+', 1) }))
    .where('id', '=', pupil)
    .returning('changes')
    .executeTakeFirstOrThrow()
  await db.insertInto('mark').values({ pupil, number, random }).execute()
  return textOf({ number, random })
}

/** The newest mark of a pupil; null if nothing has changed since marks exist. */
export async function markOf(db: Db, pupil: string): Promise<string | null> {
  const row = await db
    .selectFrom('mark')
    .select(['number', 'random'])
    .where('pupil', '=', pupil)
    .orderBy('number', 'desc')
    .limit(1)
    .executeTakeFirst()
  return row ? textOf(row) : null
}

/** Whether this database ever gave a pupil's device that mark. */
export async function knowsMark(db: Db, pupil: string, mark: string): Promise<boolean> {
  const found = /^(\d{1,9})\.([\w-]+)$/.exec(mark)
  if (!found) return false
  const row = await db
    .selectFrom('mark')
    .select('random')
    .where('pupil', '=', pupil)
    .where('number', '=', Number(found[1]))
    .executeTakeFirst()
  return row?.random === found[2]
}
