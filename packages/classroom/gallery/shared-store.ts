import type { ExpressionBuilder, Insertable } from 'kysely'
import type { Db } from '../database/database.ts'
import type { SharedTable } from '../database/gallery-tables.ts'
import type { Tables } from '../database/tables.ts'
import { assetsIn } from '../projects/assets-store.ts'
import type { Asset } from '../projects/checked.ts'
import { makeRoom } from '../projects/room-store.ts'
import {
  addPictures,
  addSpace,
  both,
  dropPictures,
  lockSpace,
  sumOf,
  type Owner,
} from '../projects/space-store.ts'

/** Who looks: a pupil of the class, or its teacher. */
export type Viewer = { readonly class: string; readonly pupil: string | null }
export type Order = 'newest' | 'hearts' | 'mine' | 'waiting' | 'hidden'
export type Row = Awaited<ReturnType<typeof sharedIn>>[number]

const onePage = 24

const rows = (db: Db) => db.selectFrom('shared').innerJoin('pupil', 'pupil.id', 'shared.pupil')

type Joined = ExpressionBuilder<Tables, 'shared' | 'pupil'>

/** A pupil sees the own, and of the others what neither waits nor is hidden; a teacher sees all. */
const mayBeSeen = (row: Joined, { class: classId, pupil }: Viewer) =>
  pupil === null
    ? row('shared.class', '=', classId)
    : row.or([
        row('shared.pupil', '=', pupil),
        row.and([row('shared.hidden', '=', 0), row('shared.waiting', '=', 0)]),
      ])

const inView = (row: Joined, viewer: Viewer, order: Order) => {
  if (order === 'mine') return row('shared.pupil', '=', viewer.pupil ?? '')
  if (order === 'waiting') return row('shared.waiting', '=', 1)
  if (order === 'hidden') return row('shared.hidden', '=', 1)
  return row.and([row('shared.hidden', '=', 0), row('shared.waiting', '=', 0)])
}

const hearts = (row: Joined) =>
  row
    .selectFrom('heart')
    .whereRef('heart.shared', '=', 'shared.id')
    .select((one) => one.fn.countAll<number>().as('count'))

const ownHearts = (row: Joined, { pupil }: Viewer) => hearts(row).where('heart.pupil', '=', pupil ?? '')

const shown = (db: Db, viewer: Viewer) =>
  rows(db)
    .select(['shared.id', 'title', 'card', 'at', 'brain', 'hidden', 'waiting', 'world', 'chain'])
    .select(['shared.pupil', 'nickname'])
    .select((row) => [hearts(row).as('hearts'), ownHearts(row, viewer).as('mine')])
    .select((row) =>
      row
        .selectFrom('sharedAsset')
        .whereRef('sharedAsset.shared', '=', 'shared.id')
        .select((one) => one.fn.countAll<number>().as('count'))
        .as('photos'),
    )
    .where('shared.class', '=', viewer.class)
    .where((row) => mayBeSeen(row, viewer))

/** A page of the gallery. @param from how many come before it */
export function sharedIn(db: Db, viewer: Viewer, order: Order, from = 0) {
  const all = shown(db, viewer).where((row) => inView(row, viewer, order))
  const sorted = order === 'hearts' ? all.orderBy('hearts', 'desc') : all
  return sorted.orderBy('at', 'desc').orderBy('shared.id').limit(onePage).offset(from).execute()
}

export async function countShared(db: Db, viewer: Viewer, order: Order): Promise<number> {
  const { count } = await rows(db)
    .select((row) => row.fn.countAll<number>().as('count'))
    .where('shared.class', '=', viewer.class)
    .where((row) => row.and([mayBeSeen(row, viewer), inView(row, viewer, order)]))
    .executeTakeFirstOrThrow()
  return count
}

/** All that a class has shared, hidden or not. */
export async function countAllShared(db: Db, classId: string): Promise<number> {
  const { count } = await db
    .selectFrom('shared')
    .select((row) => row.fn.countAll<number>().as('count'))
    .where('class', '=', classId)
    .executeTakeFirstOrThrow()
  return count
}

export const sharedOne = (db: Db, viewer: Viewer, id: string) =>
  shown(db, viewer).select('document').where('shared.id', '=', id).executeTakeFirst()

/** Titles and makers of these, as far as the viewer may see them. */
export async function madeBy(db: Db, viewer: Viewer, ids: readonly string[]) {
  if (ids.length === 0) return []
  return await rows(db)
    .select(['shared.id', 'title', 'nickname', 'shared.pupil'])
    .where('shared.class', '=', viewer.class)
    .where('shared.id', 'in', ids)
    // A teacher's own view names no more than the child's: what is hidden is out of sight in chains too.
    .where((row) => mayBeSeen(row, { ...viewer, pupil: viewer.pupil ?? '' }))
    .execute()
}

export async function assetsOfShared(db: Db, id: string) {
  const found = await db
    .selectFrom('sharedAsset')
    .innerJoin('asset', (join) =>
      join.onRef('asset.class', '=', 'sharedAsset.class').onRef('asset.hash', '=', 'sharedAsset.hash'),
    )
    .select(['sharedAsset.name', 'asset.type', 'asset.base64'])
    .where('shared', '=', id)
    .execute()
  return assetsIn(found)
}

export const sentBefore = (db: Db, pupil: string, sent: string) =>
  db
    .selectFrom('shared')
    .select(['id', 'waiting'])
    .where('pupil', '=', pupil)
    .where('sent', '=', sent)
    .executeTakeFirst()

/** Shares a snapshot, inside a transaction. @throws NoRoom: nothing of it is to stay */
export async function addShared(
  db: Db,
  row: Insertable<SharedTable>,
  assets: readonly Asset[],
): Promise<void> {
  const added = await addPictures(db, row, assets)
  await db.insertInto('shared').values(row).execute()
  const named = assets.map(({ name, hash }) => ({ shared: row.id, class: row.class, name, hash }))
  if (named.length > 0) await db.insertInto('sharedAsset').values(named).execute()
  await makeRoom(db, row, await addSpace(db, row, sumOf(both(row.bytes), added)))
}

/** Takes something out of the gallery for good. @returns false where this pupil has no such thing there */
export const removeShared = (db: Db, owner: Owner, id: string): Promise<boolean> =>
  db.transaction().execute(async (inside) => {
    await lockSpace(inside, owner)
    const named = await inside.selectFrom('sharedAsset').select('hash').where('shared', '=', id).execute()
    const gone = await inside
      .deleteFrom('shared')
      .where('id', '=', id)
      .where('pupil', '=', owner.pupil)
      .returning('bytes')
      .executeTakeFirst()
    if (!gone) return false
    const hashes = named.map(({ hash }) => hash)
    const free = sumOf(both(gone.bytes), await dropPictures(inside, owner, hashes))
    await addSpace(inside, owner, { class: -free.class, pupil: -free.pupil })
    return true
  })

/** @returns false where the class has no such thing */
export async function changeShared(
  db: Db,
  classId: string,
  id: string,
  change: { readonly hidden?: 0 | 1; readonly waiting?: 0 },
): Promise<boolean> {
  const changed = await db
    .updateTable('shared')
    .set(change)
    .where('id', '=', id)
    .where('class', '=', classId)
    .returning('id')
    .executeTakeFirst()
  return changed !== undefined
}

/** One heart a pupil: given twice it is one, taken back it is none. */
export async function setHeart(db: Db, shared: string, pupil: string, on: boolean): Promise<void> {
  if (on)
    await db
      .insertInto('heart')
      .values({ shared, pupil })
      .onConflict((conflict) => conflict.columns(['shared', 'pupil']).doNothing())
      .execute()
  else await db.deleteFrom('heart').where('shared', '=', shared).where('pupil', '=', pupil).execute()
}
