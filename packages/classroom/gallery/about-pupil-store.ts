import type { Db } from '../database/database.ts'
import { withAssets } from '../projects/assets-store.ts'
import { assetsOfShared } from './shared-store.ts'

/** A pupil's part of the gallery, each as JSON with its pictures. */
export async function* sharedOf(db: Db, pupil: string) {
  const rows = await db
    .selectFrom('shared')
    .select('id')
    .where('pupil', '=', pupil)
    .orderBy('at')
    .orderBy('id')
    .execute()
  for (const { id } of rows) {
    const row = await db
      .selectFrom('shared')
      .select(['title', 'at', 'hidden', 'waiting', 'document'])
      .where('id', '=', id)
      .executeTakeFirst()
    // The pupil has just removed it.
    if (!row) continue
    const { document, ...more } = row
    const project = withAssets(document, await assetsOfShared(db, id))
    yield `${JSON.stringify({ id, ...more }).slice(0, -1)},"project":${project}}`
  }
}

/** Ids of shared projects that have a heart of this pupil. */
export async function heartsOf(db: Db, pupil: string): Promise<readonly string[]> {
  const rows = await db.selectFrom('heart').select('shared').where('pupil', '=', pupil).execute()
  return rows.map((row) => row.shared)
}
