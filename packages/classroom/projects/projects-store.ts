import type { Db } from '../database/database.ts'
import { assetsOf, withAssets } from './assets-store.ts'
import { renewMark } from './marks-store.ts'
import { dropVersions } from './room-store.ts'
import { addSpace, type Owner } from './space-store.ts'

/** A pupil's projects, each with its newest version. */
const withHeads = (db: Db, pupil: string) =>
  db
    .selectFrom('project')
    .innerJoin('version', (join) =>
      join
        .onRef('version.pupil', '=', 'project.pupil')
        .onRef('version.project', '=', 'project.id')
        .onRef('version.revision', '=', 'project.revision'),
    )
    .where('project.pupil', '=', pupil)

/** A pupil's projects with the hash of their newest version. */
export const projectsOf = (db: Db, pupil: string) =>
  withHeads(db, pupil)
    .select(['id', 'project.revision', 'hash', 'name', 'card', 'project.savedAt'])
    .orderBy('project.savedAt', 'desc')
    .orderBy('id')
    .execute()

/** The deleted projects of a pupil, with their last revision. */
export const thrownOf = (db: Db, pupil: string) =>
  db
    .selectFrom('thrown')
    .select(['project as id', 'revision'])
    .where('pupil', '=', pupil)
    .orderBy('project')
    .execute()

/** What can be taken back, the newest first. */
export const versionsOf = (db: Db, pupil: string, project: string) =>
  db
    .selectFrom('version')
    .select(['revision', 'hash', 'savedAt', 'bytes'])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .orderBy('revision', 'desc')
    .execute()

/** The row of a version; of the newest where no revision is named. */
function rowOf(db: Db, pupil: string, project: string, revision: number | undefined) {
  const query = db
    .selectFrom('version')
    .select(['revision', 'hash', 'document', 'savedAt'])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .orderBy('revision', 'desc')
    .limit(1)
  return (revision === undefined ? query : query.where('revision', '=', revision)).executeTakeFirst()
}

/** A version as a project with its assets; the newest where no revision is named. Null where there is none. */
export async function versionOf(db: Db, pupil: string, project: string, revision?: number) {
  const row = await rowOf(db, pupil, project, revision)
  if (!row) return null
  const assets = await assetsOf(db, pupil, project, row.revision)
  const document = JSON.parse(row.document) as object
  const { hash, savedAt } = row
  return { revision: row.revision, hash, savedAt, project: { ...document, assets } }
}

/** The same as JSON, with further properties before. Its document is not read. */
export async function textOfVersion(
  db: Db,
  pupil: string,
  project: string,
  revision?: number,
  more: object = {},
): Promise<string | null> {
  const row = await rowOf(db, pupil, project, revision)
  if (!row) return null
  const { document, ...known } = row
  const assets = await assetsOf(db, pupil, project, row.revision)
  return `${JSON.stringify({ ...more, ...known }).slice(0, -1)},"project":${withAssets(document, assets)}}`
}

/** A version of a project that a device knows; no hash: a page that is older than hashes does not send one. */
export interface KnownVersion {
  readonly revision: number
  readonly hash?: string | undefined
}

/** The newest version of a project; null if there is no such project. */
export async function headOf(
  db: Db,
  pupil: string,
  id: string,
): Promise<{ readonly revision: number; readonly hash: string } | null> {
  const row = await withHeads(db, pupil)
    .select(['version.revision', 'version.hash'])
    .where('project.id', '=', id)
    .executeTakeFirst()
  return row ?? null
}

/** After a restore two versions can have one number: they are the same only with the same hash. */
export const isSame = (head: KnownVersion, known: KnownVersion): boolean =>
  head.revision === known.revision && (known.hash === undefined || head.hash === known.hash)

/**
 * Deletes a project, unless another device has saved it since.
 * @param base the version that the sender knows
 * @param random a new token, for the mark
 * @returns its mark; its newest version if that is another one; null if there is no such project
 */
export async function deleteProject(
  db: Db,
  owner: Owner,
  id: string,
  base: KnownVersion,
  random: string,
): Promise<{ readonly mark: string } | { readonly revision: number; readonly hash: string } | null> {
  const { pupil } = owner
  return db.transaction().execute(async (inside) => {
    const head = await headOf(inside, pupil, id)
    if (!head || !isSame(head, base)) return head
    const { revision } = base
    const locked = await inside
      .updateTable('project')
      .set((row) => ({ revision: row.ref('revision') }))
      .where('pupil', '=', pupil)
      .where('id', '=', id)
      .where('revision', '=', revision)
      .returning('revision')
      .executeTakeFirst()
    if (!locked) return headOf(inside, pupil, id)
    await inside
      .insertInto('thrown')
      .values({ pupil, project: id, revision })
      .onConflict((conflict) => conflict.columns(['pupil', 'project']).doUpdateSet({ revision }))
      .execute()
    const mark = await renewMark(inside, pupil, random)
    const versions = await versionsOf(inside, pupil, id)
    const free = await dropVersions(
      inside,
      { ...owner, project: id },
      versions.map((one) => one.revision),
    )
    await inside.deleteFrom('project').where('pupil', '=', pupil).where('id', '=', id).execute()
    await addSpace(inside, owner, { class: -free.class, pupil: -free.pupil })
    return { mark }
  })
}
