import { sql, type Kysely } from 'kysely'

/** Bytes that each pupil takes are counted, as those of a class are: one pupil is not to take all of its space. */
export const limits = {
  async up(db: Kysely<unknown>): Promise<void> {
    await db.schema
      .alterTable('pupil')
      .addColumn('space', 'bigint', (column) => column.notNull().defaultTo(0))
      .execute()
    await sql`
      update pupil set space =
        (select coalesce(sum(bytes), 0) from version where version.pupil = pupil.id)
        + (select coalesce(sum(bytes), 0) from shared where shared.pupil = pupil.id)
        + (select coalesce(sum(octet_length(base64)), 0) from asset
            where asset.class = pupil.class and asset.hash in (
              select hash from "versionAsset" where "versionAsset".pupil = pupil.id
              union select hash from "sharedAsset"
                join shared on shared.id = "sharedAsset".shared where shared.pupil = pupil.id))
    `.execute(db)
  },
}
