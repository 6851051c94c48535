import type { Db } from '../database/database.ts'
import type { NewPupil, PupilRow } from '../database/tables.ts'
import { tryMemory } from './tries-store.ts'

/** The class whose code this is, while joining is open. @param now of the steady clock */
export const classToJoin = (db: Db, code: string, now: number) =>
  db
    .selectFrom('class')
    .select(['id', 'name', 'language', 'grade', 'endsOn'])
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

/** Other devices were wrong too often at a nickname. */
export async function lockNickname(
  db: Db,
  { class: classId, key }: { readonly class: string; readonly key: string },
  now: number,
): Promise<void> {
  await db
    .updateTable('pupil')
    .set({ lockedAt: now })
    .where('class', '=', classId)
    .where('nicknameKey', '=', key)
    .execute()
}

/** A lock ends when the tries that led to it are forgotten. */
export const isLocked = (lockedAt: number | null, now: number): boolean =>
  lockedAt !== null && Math.abs(now - lockedAt) < tryMemory

export async function hasLocked(db: Db, classId: string, now: number): Promise<boolean> {
  const rows = await db
    .selectFrom('pupil')
    .select('lockedAt')
    .where('class', '=', classId)
    .where('lockedAt', 'is not', null)
    .execute()
  return rows.some(({ lockedAt }) => isLocked(lockedAt, now))
}

/** The teacher has opened the locks of a class. */
export async function openNicknames(db: Db, classId: string): Promise<void> {
  await db.updateTable('pupil').set({ lockedAt: null }).where('class', '=', classId).execute()
}

export async function setPictures(db: Db, id: string, pictures: string): Promise<void> {
  await db.updateTable('pupil').set({ pictures, lockedAt: null }).where('id', '=', id).execute()
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
  // Tries are counted by nickname.
  await db
    .updateTable('pupil')
    .set({ nickname, nicknameKey, lockedAt: null })
    .where('id', '=', pupil.id)
    .execute()
  return true
}
