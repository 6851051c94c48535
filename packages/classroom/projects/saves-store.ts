import type { Db } from '../database/database.ts'
import type { Checked } from './checked.ts'
import { noteResult } from '../teaching/results-store.ts'
import { markOf, renewMark } from './marks-store.ts'
import { headOf, isSame } from './projects-store.ts'
import { surplus } from './retention.ts'
import { dropVersions, makeRoom } from './room-store.ts'
import { addPictures, addSpace, both, mostSpace, sumOf, type Space } from './space-store.ts'

/** One save of a pupil as a device sends it. */
export interface Save {
  readonly pupil: string
  readonly class: string
  readonly project: string
  /** Id that the device gave the save: sent twice, it is one. */
  readonly save: string
  /** The revision it stands on; 0 for a new project. */
  readonly base: number
  /** Hash of `base`; a page that is older than hashes does not send one. */
  readonly onto?: string | undefined
  readonly checked: Checked
  readonly at: number
  /** The same by the steady clock. */
  readonly steady: number
  /** A new token, for the mark of this change. */
  readonly random: string
}

export type Saved =
  | {
      readonly kind: 'saved'
      readonly revision: number
      readonly mark: string | null
      readonly space: number
    }
  /** The class holds another version; revision 0: none. */
  | { readonly kind: 'conflict'; readonly revision: number; readonly hash?: string }
  | { readonly kind: 'classFull' }
  | { readonly kind: 'pupilFull' }
  /** The pupil's own. */
  | { readonly kind: 'tooManyProjects' }

/** A child makes some forty projects in a year. */
export const mostProjects = 100

/** Saves inside a transaction; what it answers counts once that is committed. @throws NoRoom: nothing of it is to stay */
export async function saveInside(db: Db, save: Save, most: Space = mostSpace): Promise<Saved> {
  const before = await answeredBefore(db, save)
  if (before !== null) return await saved(db, save, before)
  if (await changesNothing(db, save)) {
    await noteAnswered(db, save, save.base)
    return await saved(db, save, save.base)
  }
  if (save.base === 0 && (await isNewAndTooMany(db, save))) return { kind: 'tooManyProjects' }
  const revision = await takeRevision(db, save)
  if (revision === null) return await conflictOrSame(db, save)
  // Locks the pupil's row, before that of the class.
  const mark = await renewMark(db, save.pupil, save.random)
  // First: the new version takes the place in the file that the old one leaves, and half as much is written.
  const gone = await dropSurplus(db, save, revision)
  const added = await addVersion(db, save, revision)
  const { card, done } = save.checked
  if (card !== null) await noteResult(db, { pupil: save.pupil, class: save.class, card, done })
  const change = { class: added.class - gone.class, pupil: added.pupil - gone.pupil }
  const space = await makeRoom(db, save, await addSpace(db, save, change), most)
  return { kind: 'saved', revision, mark, space: space.class }
}

async function saved(db: Db, save: Save, revision: number): Promise<Saved> {
  const row = await db.selectFrom('class').select('space').where('id', '=', save.class).executeTakeFirst()
  return { kind: 'saved', revision, mark: await markOf(db, save.pupil), space: row?.space ?? 0 }
}

async function answeredBefore(db: Db, { pupil, save, project }: Save): Promise<number | null> {
  const row = await db
    .selectFrom('answered')
    .select('revision')
    .where('pupil', '=', pupil)
    .where('save', '=', save)
    .where('project', '=', project)
    .executeTakeFirst()
  return row?.revision ?? null
}

/** Moves the project from the revision it stands on to the next: of two devices one does. @returns null for the other one */
async function takeRevision(
  db: Db,
  { pupil, project, base, onto, checked, at, class: classId }: Save,
): Promise<number | null> {
  const { name, card } = checked
  if (base === 0) {
    const revision = (await lastRevision(db, pupil, project)) + 1
    const row = { pupil, id: project, class: classId, revision, name, card, savedAt: at }
    const added = await db
      .insertInto('project')
      .values(row)
      .onConflict((conflict) => conflict.columns(['pupil', 'id']).doNothing())
      .returning('id')
      .executeTakeFirst()
    if (!added) return null
    await db.deleteFrom('thrown').where('pupil', '=', pupil).where('project', '=', project).execute()
    return revision
  }
  const head = await headOf(db, pupil, project)
  if (!head || !isSame(head, { revision: base, hash: onto })) return null
  const moved = await db
    .updateTable('project')
    .set({ revision: base + 1, name, card, savedAt: at })
    .where('pupil', '=', pupil)
    .where('id', '=', project)
    .where('revision', '=', base)
    .returning('id')
    .executeTakeFirst()
  return moved ? base + 1 : null
}

/** Of a project that was thrown away; 0 for one that is new. */
async function lastRevision(db: Db, pupil: string, project: string): Promise<number> {
  const row = await db
    .selectFrom('thrown')
    .select('revision')
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .executeTakeFirst()
  return row?.revision ?? 0
}

async function isNewAndTooMany(db: Db, { pupil, project }: Save): Promise<boolean> {
  const { count } = await db
    .selectFrom('project')
    .select((row) => row.fn.countAll<number>().as('count'))
    .where('pupil', '=', pupil)
    .executeTakeFirstOrThrow()
  return count >= mostProjects && (await headOf(db, pupil, project)) === null
}

/** The same save on another connection, the same work from another device, or a conflict. */
async function conflictOrSame(db: Db, save: Save): Promise<Saved> {
  const before = await answeredBefore(db, save)
  if (before !== null) return await saved(db, save, before)
  const head = await headOf(db, save.pupil, save.project)
  if (head && head.hash === save.checked.hash) return await saved(db, save, head.revision)
  return { kind: 'conflict', ...(head ?? { revision: 0 }) }
}

/** A project thrown away and taken back before the class heard of it is no version more. */
async function changesNothing(db: Db, { pupil, project, base, checked }: Save): Promise<boolean> {
  const head = await headOf(db, pupil, project)
  return head !== null && isSame(head, { revision: base, hash: checked.hash })
}

/** A name of a save that another project has had already is noted no more: sent twice, the work itself is found equal. */
const noteAnswered = (db: Db, { pupil, save, project, at }: Save, revision: number) =>
  db
    .insertInto('answered')
    .values({ pupil, save, project, revision, savedAt: at })
    .onConflict((conflict) => conflict.columns(['pupil', 'save']).doNothing())
    .execute()

/** @returns bytes that it takes */
async function addVersion(db: Db, save: Save, revision: number): Promise<Space> {
  const { pupil, project, class: classId, at, steady, checked } = save
  const { document, hash, assets } = checked
  const bytes = Buffer.byteLength(document)
  const key = { pupil, project, revision, class: classId }
  const added = await addPictures(db, save, assets)
  await db
    .insertInto('version')
    .values({ ...key, savedAt: at, savedSteady: steady, bytes, hash, document })
    .execute()
  if (assets.length > 0)
    await db
      .insertInto('versionAsset')
      .values(assets.map(({ name, hash: content }) => ({ ...key, name, hash: content })))
      .execute()
  await noteAnswered(db, save, revision)
  return sumOf(both(bytes), added)
}

/** Drops the versions that are too many with this one. @returns bytes that are free then */
async function dropSurplus(db: Db, save: Save, next: number): Promise<Space> {
  const { pupil, project, steady } = save
  const rows = await db
    .selectFrom('version')
    .select(({ fn }) => ['revision', fn.coalesce('savedSteady', 'savedAt').as('savedAt')])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .execute()
  return await dropVersions(db, save, surplus([...rows, { revision: next, savedAt: steady }], steady))
}
