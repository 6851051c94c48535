import type { Entry } from '@botgarten/programs/together'
import type { Insertable } from 'kysely'
import type { Db } from '../database/database.ts'
import type { PairRow } from '../database/together-tables.ts'
import type { Tables } from '../database/tables.ts'

const columns = [
  ...(['id', 'class', 'inviter', 'invited', 'title', 'accepted', 'left', 'hand', 'length', 'bytes'] as const),
  ...(['ofInviter', 'ofInvited', 'windowEndsAt', 'inWindow', 'at'] as const),
] as const

/** The pair that a pupil is in or is asked into, the one it works in first, then the newest. */
export const pairOf = (db: Db, pupil: string): Promise<PairRow | undefined> =>
  db
    .selectFrom('pair')
    .select(columns)
    .where((row) => row.or([row('inviter', '=', pupil), row('invited', '=', pupil)]))
    // Who has left is in it no longer.
    .where((row) => row.or([row('left', 'is', null), row('left', '!=', pupil)]))
    .orderBy('accepted', 'desc')
    .orderBy('at', 'desc')
    .orderBy('id')
    .executeTakeFirst()

export const addPair = async (db: Db, row: Insertable<Tables['pair']>): Promise<void> =>
  void (await db.insertInto('pair').values(row).execute())

export const deletePair = async (db: Db, id: string): Promise<void> =>
  void (await db.deleteFrom('pair').where('id', '=', id).execute())

export const changePair = async (
  db: Db,
  id: string,
  change: Partial<Pick<PairRow, 'accepted' | 'left' | 'hand'>>,
): Promise<void> => void (await db.updateTable('pair').set(change).where('id', '=', id).execute())

/** Invitations of others to a pupil who works with somebody now. */
export const otherInvitations = (db: Db, pupil: string, but: string) =>
  db
    .deleteFrom('pair')
    .where((row) => row.or([row('inviter', '=', pupil), row('invited', '=', pupil)]))
    .where('accepted', '=', 0)
    .where('id', '!=', but)
    .returning(['inviter', 'invited'])
    .execute()

export async function documentOf(db: Db, id: string): Promise<string> {
  const row = await db.selectFrom('pair').select('document').where('id', '=', id).executeTakeFirstOrThrow()
  return row.document
}

export const nicknameOf = async (db: Db, pupil: string): Promise<string> =>
  (await db.selectFrom('pupil').select('nickname').where('id', '=', pupil).executeTakeFirst())?.nickname ?? ''

/** The common order from a place on. */
export async function entriesFrom(db: Db, pair: string, from: number, most: number): Promise<Entry[]> {
  const rows = await db
    .selectFrom('pairEntry')
    .select(['author', 'n', 'base', 'op'])
    .where('pair', '=', pair)
    .where('seq', '>=', from)
    .orderBy('seq')
    .limit(most)
    .execute()
  return rows.map(({ author, n, base, op }) => ({ by: author, n, base, op: JSON.parse(op) as Entry['op'] }))
}

/** Nobody else adds to the pair until the transaction has ended. */
export const lockPair = (db: Db, id: string): Promise<PairRow | undefined> =>
  db
    .updateTable('pair')
    .set((row) => ({ length: row.ref('length') }))
    .where('id', '=', id)
    .returning(columns)
    .executeTakeFirst()

/** Puts entries at the end of the common order. The pair is locked. */
export async function addEntries(
  db: Db,
  pair: PairRow,
  entries: readonly Entry[],
  change: Pick<PairRow, 'bytes' | 'windowEndsAt' | 'inWindow'>,
): Promise<void> {
  const last = entries.at(-1)!
  const rows = entries.map(({ by, n, base, op }, k) => ({
    ...{ pair: pair.id, seq: pair.length + k, author: by, n, base },
    op: JSON.stringify(op),
  }))
  // SQLite takes a limited number of values at once.
  for (let at = 0; at < rows.length; at += 100)
    await db
      .insertInto('pairEntry')
      .values(rows.slice(at, at + 100))
      .execute()
  await db
    .updateTable('pair')
    .set({
      ...change,
      length: pair.length + rows.length,
      [last.by === 'a' ? 'ofInviter' : 'ofInvited']: last.n,
    })
    .where('id', '=', pair.id)
    .execute()
}

export const endPairs = async (db: Db, classId: string): Promise<void> =>
  void (await db.deleteFrom('pair').where('class', '=', classId).execute())

/** What a pupil did with another one: for parents who ask. The other one's part is not theirs. */
export async function pairsOf(db: Db, pupil: string) {
  const rows = await db
    .selectFrom('pair')
    .select(['inviter', 'title', 'at', 'ofInviter', 'ofInvited'])
    .where((row) => row.or([row('inviter', '=', pupil), row('invited', '=', pupil)]))
    .execute()
  return rows.map(({ inviter, title, at, ofInviter, ofInvited }) => ({
    ...{ title, at },
    operations: inviter === pupil ? ofInviter : ofInvited,
  }))
}
