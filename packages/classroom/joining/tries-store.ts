import type { Db } from '../database/database.ts'

/** Ms after the last try until a count is forgotten: over night, and no school day has two counts. */
export const tryMemory = 18 * 3_600_000

/** Tries that are counted under a keyed hash. */
interface Tries {
  readonly count: number
  /** When they are forgotten: `tryMemory` after the last one. */
  readonly endsAt: number
}

/** The tries under a key; null if there are none, or a clock that was ahead has left them. */
export async function triesOf(db: Db, key: string, now: number): Promise<Tries | null> {
  const row = await db
    .selectFrom('attempt')
    .select(['count', 'endsAt'])
    .where('key', '=', key)
    .where('endsAt', '>', now)
    .where('endsAt', '<=', now + tryMemory)
    .executeTakeFirst()
  return row ?? null
}

/** Counts one more, if there are fewer than `most`, which is at least 1. @returns how many there are now; null: as many as there may be */
export async function countTry(db: Db, key: string, now: number, most: number): Promise<number | null> {
  const endsAt = now + tryMemory
  const fresh = await db
    .insertInto('attempt')
    .values({ key, count: 1, endsAt })
    .onConflict((conflict) =>
      conflict
        .column('key')
        .doUpdateSet({ count: 1, endsAt })
        .where((row) => row.or([row('attempt.endsAt', '<=', now), row('attempt.endsAt', '>', endsAt)])),
    )
    .returning('count')
    .executeTakeFirst()
  if (fresh) return fresh.count
  const row = await db
    .updateTable('attempt')
    .set((was) => ({ count: was('count', '+', 1), endsAt }))
    .where('key', '=', key)
    .where('count', '<', most)
    .returning('count')
    .executeTakeFirst()
  return row?.count ?? null
}

/** Counts a try after the ones that were seen. @returns whether it was this one and no other at the same time */
export async function countAfter(db: Db, key: string, seen: Tries | null, now: number): Promise<boolean> {
  if (!seen) return (await countTry(db, key, now, 1)) === 1
  const row = await db
    .updateTable('attempt')
    .set({ count: seen.count + 1, endsAt: now + tryMemory })
    .where('key', '=', key)
    .where('count', '=', seen.count)
    .returning('count')
    .executeTakeFirst()
  return row !== undefined
}

/** Takes one back: it was right. */
export async function uncountTry(db: Db, key: string): Promise<void> {
  await db
    .updateTable('attempt')
    .set((was) => ({ count: was('count', '-', 1) }))
    .where('key', '=', key)
    .where('count', '>', 0)
    .execute()
}

/** Puts the count back as it was before a try that was right: it costs no pause. */
export async function putBack(db: Db, key: string, seen: Tries | null): Promise<void> {
  if (seen)
    await db
      .updateTable('attempt')
      .set({ ...seen })
      .where('key', '=', key)
      .execute()
  else await forgetTries(db, key)
}

export async function forgetTries(db: Db, key: string): Promise<void> {
  await db.deleteFrom('attempt').where('key', '=', key).execute()
}
