import { copyFileSync, existsSync } from 'node:fs'
import { answersBeside } from '../database/answers/sqlite.ts'
import { isSound } from '../database/sound.ts'
import { forgetClass } from '../questionnaires/askings-store.ts'
import { carryOut } from '../teaching/deleting-store.ts'
import { databaseIn, openDataFolder, setAside } from './data-folder.ts'
import { buriedIn } from './tombstones.ts'

type Restored =
  { readonly kind: 'restored'; readonly before: string | null } | { readonly kind: 'notABackup' }

/** The answers of a backup, where it has some. */
function restoreAnswers(file: string, backup: string): void {
  const [answers, copy] = [answersBeside(file), answersBeside(backup)]
  if (!existsSync(copy) || !isSound(copy)) return
  if (existsSync(answers)) setAside(answers, 'before-restore')
  copyFileSync(copy, answers)
}

/**
 * Puts a backup in the place of the database, which no server may be using; the one before is kept under another name.
 * What was deleted since the backup is deleted again before anything is answered from it.
 */
export async function restore(folder: string, backup: string): Promise<Restored> {
  if (!existsSync(backup) || !isSound(backup)) return { kind: 'notABackup' }
  const file = databaseIn(folder)
  const before = existsSync(file) ? setAside(file, 'before-restore') : null
  copyFileSync(backup, file)
  restoreAnswers(file, backup)
  const opened = await openDataFolder(folder)
  if (opened.kind === 'broken') return { kind: 'notABackup' }
  const { db, answers } = opened.database
  for (const tombstone of buriedIn(folder)) {
    if (tombstone.kind === 'class') await forgetClass(answers.db, tombstone.id)
    await db.transaction().execute((inside) => carryOut(inside, tombstone))
  }
  await opened.database.close()
  return { kind: 'restored', before }
}
