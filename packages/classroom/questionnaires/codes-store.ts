import { shuffled, type Chance } from '@botgarten/answers'
import type { AnswersDatabase, AnswersDb } from '../database/answers/database.ts'
import type { AskingRow } from '../database/answers/tables.ts'
import { locked } from './askings-store.ts'

/** More than are in any class; further codes are only compared with those that were sent. */
const most = 300

/** A code that the sender of an answer has chosen: keyed hashes, since codes could be guessed. */
export interface ChosenCode {
  readonly code: string
  /** Of the answer's id. */
  readonly owner: string
}

/**
 * Reserves a code for an answer, in place of the one before, at all nodes. The codes of a form are rewritten in random order, as
 * its answers are, so that no row says when it came.
 * @returns false if the code is reserved for another answer
 */
export function reserveCode(
  answers: AnswersDatabase,
  { class: classId, key: asking }: AskingRow,
  { code, owner }: ChosenCode,
  chance: Chance,
): Promise<boolean> {
  return answers.db.transaction().execute(async (inside) => {
    await locked(answers, inside, classId)
    const rows = await inside.selectFrom('code').selectAll().where('asking', '=', asking).execute()
    const same = rows.find((row) => row.code === code)
    if (same) return same.owner === owner
    const others = rows.filter((row) => row.owner !== owner)
    if (others.length >= most) return true
    await inside.deleteFrom('code').where('asking', '=', asking).execute()
    for (const row of shuffled([...others, { asking, code, owner }], chance))
      await inside.insertInto('code').values(row).execute()
    return true
  })
}

/** Forgets the codes of a form that is closed: they are in its answers. */
export async function forgetCodes(db: AnswersDb, asking: string): Promise<void> {
  await db.deleteFrom('code').where('asking', '=', asking).execute()
}
