import type { Insertable } from 'kysely'
import type { Db } from '../database/database.ts'
import type { Tables } from '../database/tables.ts'

/** Pupils of a class who have passed a card from this many start places, but for the one who asks. */
export const finishedBy = (db: Db, classId: string, card: string, starts: number, pupil: string) =>
  db
    .selectFrom('result')
    .innerJoin('pupil', 'pupil.id', 'result.pupil')
    .select(['pupil.id', 'nickname'])
    .where('result.class', '=', classId)
    .where('card', '=', card)
    .where('done', '>=', starts)
    .where('pupil.id', '!=', pupil)
    .orderBy('nicknameKey')
    .execute()

/** What a pupil has asked, and whom. */
export const askedBy = (db: Db, pupil: string) =>
  db
    .selectFrom('peerQuestion')
    .innerJoin('pupil', 'pupil.id', 'peerQuestion.to')
    .select(['nickname as to', 'card', 'answer'])
    .where('peerQuestion.pupil', '=', pupil)
    .executeTakeFirst()

/** What a pupil is asked and has not answered, the first asked first. */
export const askedOf = (db: Db, pupil: string) =>
  db
    .selectFrom('peerQuestion')
    .innerJoin('pupil', 'pupil.id', 'peerQuestion.pupil')
    .select(['pupil.id', 'nickname as by', 'card'])
    .where('to', '=', pupil)
    .where('answer', 'is', null)
    .orderBy('at')
    .orderBy('pupil.id')
    .execute()

/** Asks; an earlier question of this pupil is over with it. */
export async function ask(db: Db, row: Insertable<Tables['peerQuestion']>): Promise<void> {
  const { pupil: _, ...change } = row
  await db
    .insertInto('peerQuestion')
    .values(row)
    .onConflict((conflict) => conflict.column('pupil').doUpdateSet(change))
    .execute()
}

/** @returns whom it was asked, null where there is no question */
export async function takeBack(db: Db, pupil: string): Promise<string | null> {
  const gone = await db
    .deleteFrom('peerQuestion')
    .where('pupil', '=', pupil)
    .returning('to')
    .executeTakeFirst()
  return gone?.to ?? null
}

/** @returns false where this pupil does not ask that one */
export async function answerTo(
  db: Db,
  pupil: string,
  to: string,
  answer: 'coming' | 'notNow',
): Promise<boolean> {
  const changed = await db
    .updateTable('peerQuestion')
    .set({ answer })
    .where('pupil', '=', pupil)
    .where('to', '=', to)
    .returning('pupil')
    .executeTakeFirst()
  return changed !== undefined
}

export async function clearQuestions(db: Db, classId: string): Promise<void> {
  await db.deleteFrom('peerQuestion').where('class', '=', classId).execute()
}
