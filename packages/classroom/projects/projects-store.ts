import type { Db } from '../database/database.ts'
import { assetsOf, recount } from './assets-store.ts'

export const projectsOf = (db: Db, pupil: string) =>
  db
    .selectFrom('project')
    .select(['id', 'revision', 'name', 'card', 'savedAt'])
    .where('pupil', '=', pupil)
    .orderBy('savedAt', 'desc')
    .orderBy('id')
    .execute()

/** Ids of what this pupil has thrown away. */
export async function thrownOf(db: Db, pupil: string): Promise<string[]> {
  const rows = await db
    .selectFrom('thrown')
    .select('project')
    .where('pupil', '=', pupil)
    .orderBy('project')
    .execute()
  return rows.map(({ project }) => project)
}

/** What can be taken back, the newest first. */
export const versionsOf = (db: Db, pupil: string, project: string) =>
  db
    .selectFrom('version')
    .select(['revision', 'savedAt', 'bytes'])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .orderBy('revision', 'desc')
    .execute()

/** A version as a project's text with its assets; the newest where no revision is named. Null where there is none. */
export async function versionOf(db: Db, pupil: string, project: string, revision?: number) {
  const query = db
    .selectFrom('version')
    .select(['revision', 'document', 'savedAt'])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .orderBy('revision', 'desc')
    .limit(1)
  const row = await (
    revision === undefined ? query : query.where('revision', '=', revision)
  ).executeTakeFirst()
  if (!row) return null
  const assets = await assetsOf(db, pupil, project, row.revision)
  const document = JSON.parse(row.document) as object
  return { revision: row.revision, savedAt: row.savedAt, project: { ...document, assets } }
}

/**
 * Throws a project away, unless another device has saved it since.
 * @param base the revision that the sender stands on
 * @returns its revision where that is another; null where there is no such project
 */
export async function deleteProject(
  db: Db,
  pupil: string,
  classId: string,
  id: string,
  base: number,
): Promise<'deleted' | number | null> {
  return db.transaction().execute(async (inside) => {
    const gone = await inside
      .deleteFrom('project')
      .where('pupil', '=', pupil)
      .where('id', '=', id)
      .where('revision', '=', base)
      .returning('revision')
      .executeTakeFirst()
    if (!gone) return revisionOf(inside, pupil, id)
    await inside
      .insertInto('thrown')
      .values({ pupil, project: id, revision: base })
      .onConflict((conflict) => conflict.columns(['pupil', 'project']).doUpdateSet({ revision: base }))
      .execute()
    await recount(inside, classId)
    return 'deleted'
  })
}

async function revisionOf(db: Db, pupil: string, id: string): Promise<number | null> {
  const row = await db
    .selectFrom('project')
    .select('revision')
    .where('pupil', '=', pupil)
    .where('id', '=', id)
    .executeTakeFirst()
  return row?.revision ?? null
}
