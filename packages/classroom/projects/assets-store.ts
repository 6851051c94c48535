import { sql, type SqlBool } from 'kysely'
import type { Db } from '../database/database.ts'
import type { Asset } from './checked.ts'

/** Keeps pictures once a class, by their hash. @returns how many bytes are new */
export async function addAssets(db: Db, classId: string, assets: readonly Asset[]): Promise<number> {
  let bytes = 0
  for (const { hash, type, base64 } of assets) {
    const added = await db
      .insertInto('asset')
      .values({ class: classId, hash, type, base64 })
      .onConflict((conflict) => conflict.columns(['class', 'hash']).doNothing())
      .returning('hash')
      .executeTakeFirst()
    if (added) bytes += base64.length
  }
  return bytes
}

/** Pictures of a class that no version and nothing shared shows. */
export const unusedAssets = (classId: string) => sql<SqlBool>`${sql.ref('asset.class')} = ${classId}
  and not exists (select 1 from ${sql.table('versionAsset')}
    where ${sql.ref('versionAsset.class')} = ${sql.ref('asset.class')}
      and ${sql.ref('versionAsset.hash')} = ${sql.ref('asset.hash')})
  and not exists (select 1 from ${sql.table('sharedAsset')}
    where ${sql.ref('sharedAsset.class')} = ${sql.ref('asset.class')}
      and ${sql.ref('sharedAsset.hash')} = ${sql.ref('asset.hash')})`

/** Deletes pictures of a class that no version and nothing shared shows, and counts its bytes again. @returns them */
export async function recount(db: Db, classId: string): Promise<number> {
  await db.deleteFrom('asset').where(unusedAssets(classId)).execute()
  const bytesOf = async (table: 'version' | 'shared') =>
    (
      await db
        .selectFrom(table)
        .select(sql<number>`coalesce(sum(bytes), 0)`.as('bytes'))
        .where('class', '=', classId)
        .executeTakeFirstOrThrow()
    ).bytes
  const assets = await db
    .selectFrom('asset')
    .select(sql<number>`coalesce(sum(length(base64)), 0)`.as('bytes'))
    .where('class', '=', classId)
    .executeTakeFirstOrThrow()
  const space = (await bytesOf('version')) + (await bytesOf('shared')) + assets.bytes
  await db.updateTable('class').set({ space }).where('id', '=', classId).execute()
  return space
}

interface NamedAsset {
  readonly name: string
  readonly type: string
  readonly base64: string
}

/** Pictures as a project holds them. */
export const assetsIn = (rows: readonly NamedAsset[]) =>
  Object.fromEntries(rows.map(({ name, type, base64 }) => [name, { type, base64 }]))

/** The pictures of a version, as a project holds them. */
export async function assetsOf(db: Db, pupil: string, project: string, revision: number) {
  const rows = await db
    .selectFrom('versionAsset')
    .innerJoin('asset', (join) =>
      join.onRef('asset.class', '=', 'versionAsset.class').onRef('asset.hash', '=', 'versionAsset.hash'),
    )
    .select(['versionAsset.name', 'asset.type', 'asset.base64'])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .where('revision', '=', revision)
    .execute()
  return assetsIn(rows)
}
