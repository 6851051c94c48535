import type { FormKey } from '@botgarten/answers/tokens'
import type { AnswersDatabase, AnswersDb } from '../database/answers/database.ts'
import type { AskingRow } from '../database/answers/tables.ts'

/** All that a class was asked. */
export const askingsOf = (db: AnswersDb, classId: string): Promise<AskingRow[]> =>
  db.selectFrom('asking').selectAll().where('class', '=', classId).execute()

/** What a class is asked now; undefined while it is asked nothing. */
export const openAskingOf = (db: AnswersDb, classId: string): Promise<AskingRow | undefined> =>
  db
    .selectFrom('asking')
    .selectAll()
    .where('class', '=', classId)
    .where('state', '=', 'open')
    .executeTakeFirst()

export const askingByKey = (db: AnswersDb, key: string): Promise<AskingRow | undefined> =>
  db.selectFrom('asking').selectAll().where('key', '=', key).executeTakeFirst()

export const askingOf = (db: AnswersDb, classId: string, form: string): Promise<AskingRow | undefined> =>
  db.selectFrom('asking').selectAll().where('class', '=', classId).where('form', '=', form).executeTakeFirst()

export async function addAsking(db: AnswersDb, row: AskingRow): Promise<void> {
  await db.insertInto('asking').values(row).execute()
}

/** Opens a form again. One that took answers without tokens until it was closed needs them from now on. */
export async function openAgain(db: AnswersDb, { key, state, secretKey }: AskingRow, made: FormKey) {
  if (state === 'closed' && secretKey === null)
    await db.updateTable('asking').set(made).where('key', '=', key).execute()
  await setState(db, key, 'open')
}

/** The forms of a class, whose answers are changed by no other transaction until this one ends. */
export function locked({ locks }: AnswersDatabase, db: AnswersDb, classId: string): Promise<AskingRow[]> {
  const query = db.selectFrom('asking').selectAll().where('class', '=', classId)
  return (locks ? query.forUpdate() : query).execute()
}

/** @param closesAt while it closes, ms of the steady clock */
export async function setState(
  db: AnswersDb,
  key: string,
  state: AskingRow['state'],
  closesAt: number | null = null,
): Promise<void> {
  await db.updateTable('asking').set({ state, closesAt }).where('key', '=', key).execute()
}

/** Classes with a form whose answers have all had their time. */
export async function classesToSettle(db: AnswersDb, now: number): Promise<readonly string[]> {
  const rows = await db
    .selectFrom('asking')
    .select('class')
    .distinct()
    .where('state', '=', 'closing')
    .where('closesAt', '<=', now)
    .execute()
  return rows.map((row) => row.class)
}

/** Classes that were asked anything. */
export async function askedClasses(db: AnswersDb): Promise<readonly string[]> {
  const rows = await db.selectFrom('asking').select('class').distinct().execute()
  return rows.map((row) => row.class)
}

/** Deletes whatever a class was asked and has answered. */
export async function forgetClass(db: AnswersDb, classId: string): Promise<void> {
  await db.deleteFrom('asking').where('class', '=', classId).execute()
  await db.deleteFrom('published').where('class', '=', classId).execute()
}
