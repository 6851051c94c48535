import type { Db } from '../database/database.ts'

/** What a pupil has in the gallery, and to what it gave its hearts: for parents who ask. */
export async function galleryOf(db: Db, pupil: string) {
  const shared = await db
    .selectFrom('shared')
    .select(['id', 'title', 'at', 'hidden', 'waiting', 'document'])
    .where('pupil', '=', pupil)
    .orderBy('at')
    .orderBy('id')
    .execute()
  const hearts = await db.selectFrom('heart').select('shared').where('pupil', '=', pupil).execute()
  return {
    shared: shared.map(({ document, ...row }) => ({ ...row, project: JSON.parse(document) as unknown })),
    hearts: hearts.map((row) => row.shared),
  }
}
