import type { Db } from '../database/database.ts'
import { hashOf } from '../hashes.ts'
import type { Ports } from '../ports.ts'

export const isOperator = async (db: Db, teacher: string): Promise<boolean> =>
  (await db.selectFrom('operator').select('teacher').where('teacher', '=', teacher).executeTakeFirst()) !==
  undefined

export async function makeOperator(db: Db, teacher: string, madeAt: number): Promise<void> {
  await db.insertInto('operator').values({ teacher, madeAt }).execute()
}

/** Is no other teacher an operator? */
export async function isOnlyOperator(db: Db, teacher: string): Promise<boolean> {
  const all = await db.selectFrom('operator').select('teacher').execute()
  return all.length === 1 && all[0]!.teacher === teacher
}

/** All teachers for the operator, sorted by name, with numbers of classes and pupils. */
export async function allTeachers(db: Db) {
  const rows = await db
    .selectFrom('teacher')
    .leftJoin('operator', 'operator.teacher', 'teacher.id')
    .leftJoin('class', 'class.teacher', 'teacher.id')
    .leftJoin('pupil', 'pupil.class', 'class.id')
    .select(['teacher.id', 'teacher.username', 'teacher.displayUsername', 'operator.madeAt'])
    .select((row) => [
      row.fn.count<number>('class.id').distinct().as('classes'),
      row.fn.count<number>('pupil.id').distinct().as('pupils'),
    ])
    .groupBy(['teacher.id', 'teacher.username', 'teacher.displayUsername', 'operator.madeAt'])
    .orderBy('teacher.username')
    .execute()
  return rows.map(({ username, displayUsername, madeAt, ...rest }) => ({
    ...rest,
    username: displayUsername ?? username,
    operator: madeAt !== null,
  }))
}

/** The first teacher and since when; undefined before there is one. */
export const firstTeacher = (db: Db) =>
  db
    .selectFrom('operator')
    .innerJoin('teacher', 'teacher.id', 'operator.teacher')
    .select(['teacher.displayUsername as name', 'operator.madeAt'])
    .orderBy('operator.madeAt')
    .executeTakeFirst()

export async function addInvitation(db: Db, token: string, first: 0 | 1, endsAt: number): Promise<void> {
  // Of the links for the first teacher only the newest one works.
  if (first) await db.deleteFrom('invitation').where('first', '=', 1).execute()
  await db
    .insertInto('invitation')
    .values({ tokenHash: hashOf(token), first, endsAt })
    .execute()
}

/**
 * Uses a link up: of two who come at once one gets it. The half hour of the first teacher's link is a duration; others end at
 * a date that was shown.
 * @returns undefined where it does not work (any more)
 */
export const takeInvitation = (db: Db, token: string, { now, steady }: Pick<Ports, 'now' | 'steady'>) =>
  db
    .deleteFrom('invitation')
    .where('tokenHash', '=', hashOf(token))
    .where((row) =>
      row.or([
        row.and([row('first', '=', 1), row('endsAt', '>', steady())]),
        row.and([row('first', '=', 0), row('endsAt', '>', now())]),
      ]),
    )
    .returning(['first', 'endsAt'])
    .executeTakeFirst()
