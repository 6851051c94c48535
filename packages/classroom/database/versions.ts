import type { Kysely } from 'kysely'

/** When a version was saved by the steady clock: a clock that was ahead for a moment deletes no earlier version. */
export const versions = {
  async up(db: Kysely<unknown>): Promise<void> {
    await db.schema.alterTable('version').addColumn('savedSteady', 'bigint').execute()
  },
}
