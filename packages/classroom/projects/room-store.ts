// A pupil's own old versions make room for her new work, and none of a pupil who takes less space than she does.
import type { Db } from '../database/database.ts'
import {
  addSpace,
  both,
  dropPictures,
  lockSpace,
  mostSpace,
  sumOf,
  type Owner,
  type Space,
} from './space-store.ts'

export type Full = 'classFull' | 'pupilFull'

/** Thrown inside the transaction, which is rolled back. */
export class NoRoom extends Error {
  readonly full: Full
  readonly owner: Owner

  constructor(full: Full, owner: Owner) {
    super(full)
    this.full = full
    this.owner = owner
  }
}

interface Version {
  readonly pupil: string
  readonly project: string
  readonly revision: number
}

/** How many versions of others are read at once. */
const several = 100

/** Versions that are not the newest of their project, the oldest first. */
const spares = (db: Db) =>
  db
    .selectFrom('version')
    .innerJoin('project', (join) =>
      join.onRef('project.pupil', '=', 'version.pupil').onRef('project.id', '=', 'version.project'),
    )
    .select(['version.pupil', 'version.project', 'version.revision'])
    .whereRef('version.revision', '<', 'project.revision')
    .orderBy(({ fn }) => fn.coalesce('version.savedSteady', 'version.savedAt'))
    .orderBy('version.revision')

const sparesOf = (db: Db, { pupil }: Owner) => spares(db).where('version.pupil', '=', pupil).execute()

/** Of pupils who take more space than this one. */
const sparesOfLarger = (db: Db, owner: Owner, than: number) =>
  spares(db)
    .innerJoin('pupil', 'pupil.id', 'version.pupil')
    .where('version.class', '=', owner.class)
    .where('pupil.space', '>', than)
    .limit(several)
    .execute()

/** Deletes versions of one project with the pictures that nothing shows then. @returns bytes that are free now */
export async function dropVersions(
  db: Db,
  { pupil, project, class: classId }: Owner & { readonly project: string },
  revisions: readonly number[],
): Promise<Space> {
  if (revisions.length === 0) return both(0)
  const owner = { pupil, class: classId }
  const named = await db
    .selectFrom('versionAsset')
    .select('hash')
    .distinct()
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .where('revision', 'in', revisions)
    .execute()
  if (named.length > 0) await lockSpace(db, owner)
  const gone = await db
    .deleteFrom('version')
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .where('revision', 'in', revisions)
    .returning('bytes')
    .execute()
  const bytes = gone.reduce((sum, row) => sum + row.bytes, 0)
  const pictures = await dropPictures(
    db,
    owner,
    named.map(({ hash }) => hash),
  )
  return sumOf(both(bytes), pictures)
}

async function drop(db: Db, classId: string, { pupil, project, revision }: Version): Promise<Space> {
  const owner = { pupil, class: classId }
  const free = await dropVersions(db, { ...owner, project }, [revision])
  return await addSpace(db, owner, { class: -free.class, pupil: -free.pupil })
}

/**
 * Deletes old versions until a pupil and the class have no more than they may.
 * @param taken bytes with the change
 * @returns bytes after it
 * @throws NoRoom where there is not enough that may go
 */
export async function makeRoom(db: Db, owner: Owner, taken: Space, most: Space = mostSpace): Promise<Space> {
  let space = taken
  const isOver = () => space.pupil > most.pupil || space.class > most.class
  if (!isOver()) return space
  for (const version of await sparesOf(db, owner)) {
    space = await drop(db, owner.class, version)
    if (!isOver()) return space
  }
  if (space.pupil > most.pupil) throw new NoRoom('pupilFull', owner)
  for (const version of await sparesOfLarger(db, owner, space.pupil)) {
    space = { ...space, class: (await drop(db, owner.class, version)).class }
    if (!isOver()) return space
  }
  throw new NoRoom('classFull', owner)
}
