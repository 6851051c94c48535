import type { Db } from '../database/database.ts'

const month = 30 * 86_400_000

/** Deletes what has had its time: counted tries, links, and which saves were answered a month ago. */
export async function clearAway(db: Db, now: number, day: string): Promise<void> {
  await db.deleteFrom('attempt').where('endsAt', '<=', now).execute()
  // The link for the first teacher ends by the steady clock; a new one replaces it.
  await db.deleteFrom('invitation').where('first', '=', 0).where('endsAt', '<=', now).execute()
  await db.deleteFrom('substitute').where('day', '<', day).execute()
  // A device that sends a save again after so long stands on an old revision by then, or saves the same work.
  await db
    .deleteFrom('answered')
    .where('savedAt', '<', now - month)
    .execute()
}

export async function allClasses(db: Db): Promise<readonly string[]> {
  const rows = await db.selectFrom('class').select('id').execute()
  return rows.map(({ id }) => id)
}
