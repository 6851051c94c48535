import type { Kysely } from 'kysely'

/**
 * When a pupil showed the pictures, by the steady clock too: a clock that is set back lengthens no lesson. Sessions of earlier
 * versions have no such time.
 */
export const days = {
  async up(db: Kysely<unknown>): Promise<void> {
    await db.schema.alterTable('pupilSession').addColumn('provenSteady', 'bigint').execute()
  },
}
