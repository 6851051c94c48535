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

/** @returns false where there is no such project */
export async function deleteProject(db: Db, pupil: string, classId: string, id: string): Promise<boolean> {
  const gone = await db
    .deleteFrom('project')
    .where('pupil', '=', pupil)
    .where('id', '=', id)
    .returning('id')
    .executeTakeFirst()
  if (gone) await recount(db, classId)
  return gone !== undefined
}
