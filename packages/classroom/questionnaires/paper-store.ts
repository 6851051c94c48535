import type { PaperCounts } from '@botgarten/answers'
import type { AnswersDatabase, AnswersDb } from '../database/answers/database.ts'
import type { AskingRow } from '../database/answers/tables.ts'
import { locked } from './askings-store.ts'

/** Counts that were typed in from sheets of paper, by key of their form. */
export async function papersOf(
  db: AnswersDb,
  keys: readonly string[],
): Promise<readonly (PaperCounts & { readonly asking: string })[]> {
  if (keys.length === 0) return []
  const rows = await db
    .selectFrom('paper')
    .select(['asking', 'document'])
    .where('asking', 'in', keys)
    .execute()
  return rows.map(({ asking, document }) => ({ asking, ...(JSON.parse(document) as PaperCounts) }))
}

/**
 * Draws a token for each sheet of paper, and adds the counts.
 * @param paper id of the row, its counts, and the number of tokens for paper that the form has
 * @returns false if fewer tokens are left than there are sheets
 */
export function addPaper(
  answers: AnswersDatabase,
  { class: classId, key: asking }: AskingRow,
  { id, counts, tokens }: { readonly id: string; readonly counts: PaperCounts; readonly tokens: number },
): Promise<boolean> {
  return answers.db.transaction().execute(async (inside) => {
    await locked(answers, inside, classId)
    const drawn = (await papersOf(inside, [asking])).reduce((sum, { n }) => sum + n, 0)
    if (drawn + counts.n > tokens) return false
    await inside
      .insertInto('paper')
      .values({ asking, id, document: JSON.stringify(counts) })
      .execute()
    return true
  })
}

export async function removePaper(db: AnswersDb, asking: string): Promise<void> {
  await db.deleteFrom('paper').where('asking', '=', asking).execute()
}
