import type { Db } from '../database/database.ts'

export const resultsOf = (db: Db, classId: string) =>
  db.selectFrom('result').select(['pupil', 'card', 'done']).where('class', '=', classId).execute()

export const resultsOfPupil = (db: Db, pupil: string) =>
  db.selectFrom('result').select(['card', 'done']).where('pupil', '=', pupil).orderBy('card').execute()

/** Notes from how many start places a pupil has passed; fewer than before change nothing. */
export async function noteResult(
  db: Db,
  row: { readonly pupil: string; readonly class: string; readonly card: string; readonly done: number },
): Promise<void> {
  await db
    .insertInto('result')
    .values(row)
    .onConflict((conflict) =>
      conflict.columns(['pupil', 'card']).doUpdateSet({ done: row.done }).where('result.done', '<', row.done),
    )
    .execute()
}
