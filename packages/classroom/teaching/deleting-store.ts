import type { Db } from '../database/database.ts'
import { deleteUnheld } from '../live/handouts-store.ts'
import type { Tombstone } from '../ports.ts'
import { recount } from '../projects/space-store.ts'
import { deleteTeacherRow } from './accounts-store.ts'

/**
 * Deletes a class, a pupil or a teacher with all that hangs on it. What the database remembers is the id alone, so that a device
 * that comes back is told. Doing it again changes nothing: after a restore every tombstone is carried out.
 */
export async function carryOut(db: Db, { kind, id }: Tombstone): Promise<void> {
  const pupil = await db.selectFrom('pupil').select('class').where('id', '=', id).executeTakeFirst()
  if (kind === 'class') {
    // The rest hangs on it, and the database deletes it along.
    await db.deleteFrom('class').where('id', '=', id).execute()
  } else if (kind === 'teacher') {
    // Classes are deleted by tombstones of their own, and never along with a teacher.
    await deleteTeacherRow(db, id)
  } else if (pupil) {
    await db.deleteFrom('pupil').where('id', '=', id).execute()
    await deleteUnheld(db)
    await recount(db, pupil.class)
  }
  await addTombstone(db, { kind, id })
}

/** PostgreSQL: the table of tombstones has a page with room from now on, so that a deletion needs no other on a full disk. */
export async function reserveTombstone(db: Db): Promise<void> {
  const id = 'reserved'
  await addTombstone(db, { kind: 'class', id })
  await db.deleteFrom('tombstone').where('id', '=', id).execute()
}

/** Notes an id, so that devices learn of the deletion at their next visit. */
export async function addTombstone(db: Db, { kind, id }: Tombstone): Promise<void> {
  await db
    .insertInto('tombstone')
    .values({ kind, id })
    .onConflict((conflict) => conflict.column('id').doNothing())
    .execute()
}

/** Deletions that were interrupted: the class or the pupil still exists. */
export async function begunDeletions(db: Db): Promise<readonly Tombstone[]> {
  const rows = await db
    .selectFrom('tombstone')
    .select(['kind', 'id'])
    .where((row) =>
      row.or([
        row('id', 'in', row.selectFrom('class').select('class.id')),
        row('id', 'in', row.selectFrom('pupil').select('pupil.id')),
      ]),
    )
    .execute()
  return rows.map(({ kind, id }) => ({ kind: kind === 'class' ? 'class' : 'pupil', id }))
}
