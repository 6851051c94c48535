import type { Db } from '../database/database.ts'

/**
 * Gives a pupil the one token for a form. The same blinded input is the same token, however often the answer to it is lost.
 * @param blinded hash of the blinded input
 * @returns false if the pupil was given the token for another input
 */
export async function giveToken(db: Db, pupil: string, form: string, blinded: string): Promise<boolean> {
  await db
    .insertInto('token')
    .values({ pupil, form, blinded })
    .onConflict((conflict) =>
      conflict.columns(['pupil', 'form']).doUpdateSet({ blinded }).where('token.blinded', 'is', null),
    )
    .execute()
  const query = db.selectFrom('token').select('blinded').where('pupil', '=', pupil).where('form', '=', form)
  return (await query.executeTakeFirst())?.blinded === blinded
}

/** Ids of the forms that a pupil has opened. */
export async function formsOpenedBy(db: Db, pupil: string): Promise<readonly string[]> {
  const query = db.selectFrom('token').select('form').where('pupil', '=', pupil)
  return (await query.orderBy('form').execute()).map(({ form }) => form)
}

/**
 * Allows one further token, for a pupil whose device has lost the first.
 * @returns false if it was allowed before
 */
export async function allowAgain(db: Db, pupil: string, form: string): Promise<boolean> {
  const rows = db.selectFrom('token').select('again').where('pupil', '=', pupil).where('form', '=', form)
  const row = await rows.executeTakeFirst()
  if (!row) return true
  const allowed = await db
    .updateTable('token')
    .set({ blinded: null, again: 1 })
    .where('pupil', '=', pupil)
    .where('form', '=', form)
    .where('again', '=', 0)
    .executeTakeFirst()
  return allowed.numUpdatedRows > 0n
}
