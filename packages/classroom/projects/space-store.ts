// Bytes that a class and each of its pupils take, counted along with each change. A picture is stored once a class, and counts
// once for the class and once for each pupil who uses it.
import { sql, type SqlBool } from 'kysely'
import type { Db } from '../database/database.ts'
import type { Asset } from './checked.ts'

/** Bytes at the most: of a class, and of one of its pupils, who has ten of the largest projects then. */
export const mostSpace = { class: 500_000_000, pupil: 50_000_000 } as const

export interface Owner {
  readonly pupil: string
  readonly class: string
}

/** Bytes of a class and of a pupil. */
export interface Space {
  readonly class: number
  readonly pupil: number
}

const none: Space = { class: 0, pupil: 0 }

export const sumOf = (...spaces: readonly Space[]): Space =>
  spaces.reduce((sum, one) => ({ class: sum.class + one.class, pupil: sum.pupil + one.pupil }), none)

/** The same bytes for both. */
export const both = (bytes: number): Space => ({ class: bytes, pupil: bytes })

/** Counts more or fewer bytes. Locks both rows, the pupil's first. @returns bytes after it */
export async function addSpace(db: Db, owner: Owner, change: Space): Promise<Space> {
  const add = async (table: 'pupil' | 'class') => {
    const row = await db
      .updateTable(table)
      .set((row) => ({ space: row('space', '+', change[table]) }))
      .where('id', '=', owner[table])
      .returning('space')
      .executeTakeFirst()
    return row?.space ?? 0
  }
  return { pupil: await add('pupil'), class: await add('class') }
}

/** Until the transaction ends no other transaction adds or deletes pictures of the class. */
export const lockSpace = (db: Db, owner: Owner): Promise<Space> => addSpace(db, owner, none)

/** Of these pictures those that a pupil uses. */
async function usedBy(db: Db, pupil: string, hashes: readonly string[]): Promise<ReadonlySet<string>> {
  const inVersions = db
    .selectFrom('versionAsset')
    .select('hash')
    .where('pupil', '=', pupil)
    .where('hash', 'in', hashes)
  const inShared = db
    .selectFrom('sharedAsset')
    .innerJoin('shared', 'shared.id', 'sharedAsset.shared')
    .select('hash')
    .where('shared.pupil', '=', pupil)
    .where('hash', 'in', hashes)
  const rows = await inVersions.union(inShared).execute()
  return new Set(rows.map(({ hash }) => hash))
}

/** Stores pictures once a class, by their hash, before the rows that show them. @returns bytes that they take */
export async function addPictures(db: Db, owner: Owner, assets: readonly Asset[]): Promise<Space> {
  if (assets.length === 0) return none
  await lockSpace(db, owner)
  const hashes = assets.map(({ hash }) => hash)
  const used = await usedBy(db, owner.pupil, hashes)
  let ofClass = 0
  for (const { hash, type, base64 } of assets) {
    const added = await db
      .insertInto('asset')
      .values({ class: owner.class, hash, type, base64 })
      .onConflict((conflict) => conflict.columns(['class', 'hash']).doNothing())
      .returning('hash')
      .executeTakeFirst()
    if (added) ofClass += base64.length
  }
  const news = new Map(assets.map(({ hash, base64 }) => [hash, base64.length]))
  const ofPupil = [...news].reduce((sum, [hash, bytes]) => sum + (used.has(hash) ? 0 : bytes), 0)
  return { class: ofClass, pupil: ofPupil }
}

const bytesOfPictures = (db: Db, classId: string, hashes: readonly string[]) =>
  db
    .selectFrom('asset')
    .select(['hash', sql<number>`octet_length(base64)`.as('bytes')])
    .where('class', '=', classId)
    .where('hash', 'in', hashes)
    .execute()

/** Deletes those of these pictures that nothing in the class shows any more. @returns bytes that are free now */
export async function dropPictures(db: Db, owner: Owner, hashes: readonly string[]): Promise<Space> {
  if (hashes.length === 0) return none
  const pictures = await bytesOfPictures(db, owner.class, hashes)
  const used = await usedBy(db, owner.pupil, hashes)
  await deleteUnused(db, owner.class, hashes)
  const left = new Set((await bytesOfPictures(db, owner.class, hashes)).map(({ hash }) => hash))
  const sum = (kept: ReadonlySet<string>) =>
    pictures.reduce((bytes, picture) => bytes + (kept.has(picture.hash) ? 0 : picture.bytes), 0)
  return { class: sum(left), pupil: sum(used) }
}

/** Pictures of a class that no version and nothing shared shows. */
export const unusedAssets = (classId: string) => sql<SqlBool>`${sql.ref('asset.class')} = ${classId}
  and not exists (select 1 from ${sql.table('versionAsset')}
    where ${sql.ref('versionAsset.class')} = ${sql.ref('asset.class')}
      and ${sql.ref('versionAsset.hash')} = ${sql.ref('asset.hash')})
  and not exists (select 1 from ${sql.table('sharedAsset')}
    where ${sql.ref('sharedAsset.class')} = ${sql.ref('asset.class')}
      and ${sql.ref('sharedAsset.hash')} = ${sql.ref('asset.hash')})`

/** Deletes unused pictures. @param hashes of those that may go; none: all of the class */
async function deleteUnused(db: Db, classId: string, hashes?: readonly string[]): Promise<void> {
  const unused = db.deleteFrom('asset').where(unusedAssets(classId))
  await (hashes === undefined ? unused : unused.where('hash', 'in', hashes)).execute()
}

/** Deletes unused pictures of a class, and counts its bytes and those of its pupils again from the stored rows. */
export async function recount(db: Db, classId: string): Promise<void> {
  await deleteUnused(db, classId)
  await sql`
    update class set space =
      (select coalesce(sum(bytes), 0) from version where version.class = class.id)
      + (select coalesce(sum(bytes), 0) from shared where shared.class = class.id)
      + (select coalesce(sum(octet_length(base64)), 0) from asset where asset.class = class.id)
    where id = ${classId}
  `.execute(db)
  await sql`
    update pupil set space =
      (select coalesce(sum(bytes), 0) from version where version.pupil = pupil.id)
      + (select coalesce(sum(bytes), 0) from shared where shared.pupil = pupil.id)
      + (select coalesce(sum(octet_length(base64)), 0) from asset
          where asset.class = pupil.class and asset.hash in (
            select hash from "versionAsset" where "versionAsset".pupil = pupil.id
            union select hash from "sharedAsset"
              join shared on shared.id = "sharedAsset".shared where shared.pupil = pupil.id))
    where class = ${classId}
  `.execute(db)
}
