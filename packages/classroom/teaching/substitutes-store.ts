import type { Db } from '../database/database.ts'
import type { ClassRow } from '../database/tables.ts'
import { hashOf } from '../hashes.ts'

export async function addSubstitute(db: Db, token: string, classId: string, day: string): Promise<void> {
  await db
    .insertInto('substitute')
    .values({ tokenHash: hashOf(token), class: classId, day })
    .execute()
}

export async function endSubstitutes(db: Db, classId: string): Promise<void> {
  await db.deleteFrom('substitute').where('class', '=', classId).execute()
}

/** The class that a link of a substitute opens on this day. */
export const classLent = (db: Db, token: string, day: string): Promise<ClassRow | undefined> =>
  db
    .selectFrom('substitute')
    .innerJoin('class', 'class.id', 'substitute.class')
    .selectAll('class')
    .where('tokenHash', '=', hashOf(token))
    .where('day', '=', day)
    .executeTakeFirst()
