import type { Db } from '../database/database.ts'
import type { NewPupil, PupilRow } from '../database/tables.ts'

/** The class whose code this is, while joining is open. */
export const classToJoin = (db: Db, code: string, now: number) =>
  db
    .selectFrom('class')
    .select(['id', 'name', 'language', 'grade'])
    .where('code', '=', code)
    .where('joiningUntil', '>', now)
    .executeTakeFirst()

/** @returns false where another pupil of the class has this nickname */
export async function addPupil(db: Db, pupil: NewPupil): Promise<boolean> {
  const added = await db
    .insertInto('pupil')
    .values(pupil)
    .onConflict((conflict) => conflict.columns(['class', 'nicknameKey']).doNothing())
    .returning('id')
    .executeTakeFirst()
  return added !== undefined
}

export async function countPupils(db: Db, classId: string): Promise<number> {
  const { count } = await db
    .selectFrom('pupil')
    .select((row) => row.fn.countAll<number>().as('count'))
    .where('class', '=', classId)
    .executeTakeFirstOrThrow()
  return count
}

export const pupilCalled = (db: Db, classId: string, nicknameKey: string) =>
  db
    .selectFrom('pupil')
    .selectAll()
    .where('class', '=', classId)
    .where('nicknameKey', '=', nicknameKey)
    .executeTakeFirst()

export const pupilOf = (db: Db, classId: string, id: string): Promise<PupilRow | undefined> =>
  db.selectFrom('pupil').selectAll().where('class', '=', classId).where('id', '=', id).executeTakeFirst()

export const pupilsOf = (db: Db, classId: string) =>
  db
    .selectFrom('pupil')
    .select(['id', 'nickname', 'lockedAt', 'handAt', 'isNew', 'joinedAt'])
    .where('class', '=', classId)
    .orderBy('nicknameKey')
    .execute()

const wrongBeforeLock = 5

/** Counts wrong pictures; the fifth in a row locks the nickname for new devices. */
export async function countWrongOf(db: Db, id: string, now: number): Promise<void> {
  await db
    .updateTable('pupil')
    .set((row) => ({ wrong: row('wrong', '+', 1) }))
    .where('id', '=', id)
    .execute()
  await db
    .updateTable('pupil')
    .set({ lockedAt: now })
    .where('id', '=', id)
    .where('wrong', '>=', wrongBeforeLock)
    .where('lockedAt', 'is', null)
    .execute()
}

/** The pictures were right, or the teacher opened the lock. */
export async function unlock(db: Db, id: string): Promise<void> {
  await db.updateTable('pupil').set({ wrong: 0, lockedAt: null }).where('id', '=', id).execute()
}

export async function setPictures(db: Db, id: string, pictures: string): Promise<void> {
  await db.updateTable('pupil').set({ pictures, wrong: 0, lockedAt: null }).where('id', '=', id).execute()
}

/** @param at when the hand went up; null: it is down */
export async function setHand(db: Db, id: string, at: number | null): Promise<void> {
  await db.updateTable('pupil').set({ handAt: at }).where('id', '=', id).execute()
}

/** @returns false where another pupil of the class has this nickname */
export async function rename(
  db: Db,
  pupil: PupilRow,
  nickname: string,
  nicknameKey: string,
): Promise<boolean> {
  const other = await pupilCalled(db, pupil.class, nicknameKey)
  if (other && other.id !== pupil.id) return false
  await db.updateTable('pupil').set({ nickname, nicknameKey }).where('id', '=', pupil.id).execute()
  return true
}
