import { nothingReleased, released, shuffled, type Chance, type Release } from '@botgarten/answers'
import type { AnswersDatabase, AnswersDb } from '../database/answers/database.ts'
import type { AnswerRow, AskingRow } from '../database/answers/tables.ts'
import { answerIn, inTime } from './asked.ts'
import { locked } from './askings-store.ts'
import { forgetCodes } from './codes-store.ts'
import { papersOf } from './paper-store.ts'

const rowsOf = (db: AnswersDb, asking: string): Promise<AnswerRow[]> =>
  db.selectFrom('answer').selectAll().where('asking', '=', asking).execute()

/** All rows of a form are written anew in random order: neither their places nor their transactions say which came when. */
async function rewrite(db: AnswersDb, asking: string, rows: readonly AnswerRow[], chance: Chance) {
  await db.deleteFrom('answer').where('asking', '=', asking).execute()
  for (const row of shuffled(rows, chance)) await db.insertInto('answer').values(row).execute()
}

async function isIn(db: AnswersDb, askings: readonly string[], id: string): Promise<boolean> {
  if (askings.length === 0) return false
  const query = db.selectFrom('answer').select('id').where('asking', 'in', askings).where('id', '=', id)
  return (await query.executeTakeFirst()) !== undefined
}

/** `same`: it came before · `other`: its id has another answer already · `full`: there is no room. */
type Taken = 'new' | 'same' | 'other' | 'full'

/** Takes an answer in among the others. One that is there already stays as it is. */
export function takeAnswer(
  answers: AnswersDatabase,
  { class: classId }: AskingRow,
  answer: AnswerRow,
  most: number,
  chance: Chance,
): Promise<Taken> {
  return answers.db.transaction().execute(async (inside) => {
    const askings = await locked(answers, inside, classId)
    const rows = await rowsOf(inside, answer.asking)
    const before = rows.find(({ id }) => id === answer.id)
    if (before) return before.code === answer.code && before.chosen === answer.chosen ? 'same' : 'other'
    // What is published is known by ids: one that was drawn again would be counted with another form.
    const others = askings.map(({ key }) => key).filter((key) => key !== answer.asking)
    if (rows.length >= most || (await isIn(inside, others, answer.id))) return 'full'
    await rewrite(inside, answer.asking, [...rows, answer], chance)
    return 'new'
  })
}

export const hasAnswer = (db: AnswersDb, asking: string, id: string): Promise<boolean> =>
  isIn(db, [asking], id)

/** Has somebody else answered under this code? */
export async function hasCode(db: AnswersDb, asking: string, code: string, id: string): Promise<boolean> {
  const query = db.selectFrom('answer').select('id').where('asking', '=', asking).where('code', '=', code)
  return (await query.where('id', '!=', id).executeTakeFirst()) !== undefined
}

/** By key of a form, how many have answered. */
export async function countsOf(db: AnswersDb, keys: readonly string[]): Promise<ReadonlyMap<string, number>> {
  if (keys.length === 0) return new Map()
  const rows = await db
    .selectFrom('answer')
    .select((row) => ['asking', row.fn.countAll<number>().as('count')])
    .where('asking', 'in', keys)
    .groupBy('asking')
    .execute()
  return new Map(rows.map(({ asking, count }) => [asking, count]))
}

async function releaseOf(db: AnswersDb, classId: string): Promise<Release> {
  const query = db.selectFrom('published').select('document').where('class', '=', classId)
  const row = await query.executeTakeFirst()
  return row ? (JSON.parse(row.document) as Release) : nothingReleased
}

async function writeRelease(db: AnswersDb, classId: string, release: Release): Promise<void> {
  const document = JSON.stringify(release)
  await db
    .insertInto('published')
    .values({ class: classId, document })
    .onConflict((conflict) => conflict.column('class').doUpdateSet({ document }))
    .execute()
}

/** Everything that was answered to forms of a class, and what of it is published. */
export async function answersTo(db: AnswersDb, classId: string, askings: readonly AskingRow[]) {
  const perForm = await Promise.all(
    askings.map(async (asking) => (await rowsOf(db, asking.key)).map((row) => answerIn(asking, row))),
  )
  const paper = await papersOf(
    db,
    askings.map(({ key }) => key),
  )
  return { answers: perForm.flat(), release: await releaseOf(db, classId), paper }
}

/**
 * Closes what has had its time: rows are written anew in random order in one transaction, what may be published is, and the
 * database is written anew.
 */
export async function settle(
  answers: AnswersDatabase,
  classId: string,
  now: number,
  chance: Chance,
): Promise<void> {
  const isDue = ({ state, closesAt }: AskingRow) => state === 'closing' && (closesAt ?? 0) <= now
  const done = await answers.db.transaction().execute(async (inside) => {
    const all = await locked(answers, inside, classId)
    const due = all.filter(isDue)
    if (due.length === 0) return false
    for (const { key } of due) {
      await rewrite(inside, key, await rowsOf(inside, key), chance)
      await forgetCodes(inside, key)
      await inside
        .updateTable('asking')
        .set({ state: 'closed', closesAt: null })
        .where('key', '=', key)
        .execute()
    }
    const closed = inTime(all.filter((one) => one.state === 'closed' || isDue(one)))
    const before = await answersTo(inside, classId, closed)
    const forms = closed.map(({ form }) => form)
    await writeRelease(inside, classId, released(before.release, before.answers, forms, chance))
    return true
  })
  if (done) await answers.vacuum()
}

/**
 * Deletes from a copy what is not published: two copies, of one night and the next, never differ by fewer than five people.
 */
export async function keepPublished(db: AnswersDb): Promise<void> {
  const rows = await db.selectFrom('published').selectAll().execute()
  const there = new Set(
    rows.flatMap(({ document }) => (JSON.parse(document) as Release).batches.flatMap(({ ids }) => ids)),
  )
  for (const { asking, id } of await db.selectFrom('answer').select(['asking', 'id']).execute())
    if (!there.has(id))
      await db.deleteFrom('answer').where('asking', '=', asking).where('id', '=', id).execute()
  await db.deleteFrom('code').execute()
}
