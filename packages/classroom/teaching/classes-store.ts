import type { Insertable, Updateable } from 'kysely'
import { clearQuestions } from '../asking/peers-store.ts'
import { endPairs } from '../together/pairs-store.ts'
import type { Db } from '../database/database.ts'
import type { ClassRow, ClassTable } from '../database/tables.ts'

export const classOf = (db: Db, id: string, teacher: string): Promise<ClassRow | undefined> =>
  db.selectFrom('class').selectAll().where('id', '=', id).where('teacher', '=', teacher).executeTakeFirst()

export const classById = (db: Db, id: string): Promise<ClassRow | undefined> =>
  db.selectFrom('class').selectAll().where('id', '=', id).executeTakeFirst()

export const classesOf = (db: Db, teacher: string): Promise<ClassRow[]> =>
  db.selectFrom('class').selectAll().where('teacher', '=', teacher).orderBy('madeAt').execute()

/** @returns false where another class has this code */
export async function addClass(db: Db, row: Insertable<ClassTable>): Promise<boolean> {
  const added = await db
    .insertInto('class')
    .values(row)
    .onConflict((conflict) => conflict.column('code').doNothing())
    .returning('id')
    .executeTakeFirst()
  return added !== undefined
}

export async function changeClass(db: Db, id: string, change: Updateable<ClassTable>): Promise<void> {
  await db.updateTable('class').set(change).where('id', '=', id).execute()
}

/** The lesson is over: nobody is new any more, no hand is up, nobody is asked. */
export async function closeClass(db: Db, id: string): Promise<void> {
  await db
    .updateTable('class')
    .set((row) => ({ openedAt: null, joiningUntil: 0, lesson: row('lesson', '+', 1) }))
    .where('id', '=', id)
    .execute()
  await db.updateTable('pupil').set({ isNew: 0, handAt: null }).where('class', '=', id).execute()
  await clearQuestions(db, id)
  await endPairs(db, id)
}

/** How much a class holds. */
export async function sizesOf(db: Db, classId: string) {
  const count = async (table: 'pupil' | 'project' | 'version') =>
    (
      await db
        .selectFrom(table)
        .select((row) => row.fn.countAll<number>().as('count'))
        .where('class', '=', classId)
        .executeTakeFirstOrThrow()
    ).count
  return { pupils: await count('pupil'), projects: await count('project'), versions: await count('version') }
}

/** @returns false where another class has this code */
export async function giveCode(db: Db, id: string, code: string): Promise<boolean> {
  const taken = await db.selectFrom('class').select('id').where('code', '=', code).executeTakeFirst()
  if (!taken) await changeClass(db, id, { code })
  return !taken
}

/** What a pupil sees of the class. */
export const classOfPupil = (db: Db, id: string) =>
  db
    .selectFrom('class')
    .select(['id', 'name', 'language', 'grade', 'openedAt', 'cards', 'level'])
    .select(['gallery', 'asking', 'together'])
    .where('id', '=', id)
    .executeTakeFirst()

/** Sizes of all classes for who runs the server: no name of a class, nothing of what is in it. */
export const sizesOfAll = (db: Db) =>
  db
    .selectFrom('class')
    .leftJoin('pupil', 'pupil.class', 'class.id')
    .select((row) => ['class.id', 'class.space', row.fn.count<number>('pupil.id').as('pupils')])
    .groupBy(['class.id', 'class.space'])
    .orderBy('class.id')
    .execute()
