import type { PaperCounts } from '@botgarten/answers'
import type { AnswersDb } from '../database/answers/database.ts'

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

export async function addPaper(
  db: AnswersDb,
  asking: string,
  id: string,
  counts: PaperCounts,
): Promise<void> {
  await db
    .insertInto('paper')
    .values({ asking, id, document: JSON.stringify(counts) })
    .execute()
}

export async function removePaper(db: AnswersDb, asking: string): Promise<void> {
  await db.deleteFrom('paper').where('asking', '=', asking).execute()
}
