import type { Db } from '../database/database.ts'

/** Id of the teacher with this username, in any capitals. */
export async function teacherCalled(db: Db, username: string): Promise<string | undefined> {
  const row = await db
    .selectFrom('teacher')
    .select('id')
    .where('username', '=', username.toLowerCase())
    .executeTakeFirst()
  return row?.id
}

export async function setPassword(db: Db, teacher: string, hash: string): Promise<void> {
  await db.updateTable('account').set({ password: hash }).where('userId', '=', teacher).execute()
}

export async function endSessionsOfTeacher(db: Db, teacher: string): Promise<void> {
  await db.deleteFrom('teacherSession').where('userId', '=', teacher).execute()
}

/** Ends all sessions of a teacher but one. */
export async function endOtherSessions(db: Db, teacher: string, session: string): Promise<void> {
  await db.deleteFrom('teacherSession').where('userId', '=', teacher).where('id', '!=', session).execute()
}

/** Deletes a teacher without classes, with sessions and password. @returns false if there is none, or one with classes */
export async function deleteTeacherRow(db: Db, id: string): Promise<boolean> {
  const deleted = await db
    .deleteFrom('teacher')
    .where('id', '=', id)
    .where((row) =>
      row.not(row.exists(row.selectFrom('class').select('class.id').where('class.teacher', '=', id))),
    )
    .returning('id')
    .executeTakeFirst()
  return deleted !== undefined
}

/** Hash of a teacher's password; null if there is none. */
export async function passwordHashOf(db: Db, teacher: string): Promise<string | null> {
  const row = await db
    .selectFrom('account')
    .select('password')
    .where('userId', '=', teacher)
    .executeTakeFirst()
  return row?.password ?? null
}
