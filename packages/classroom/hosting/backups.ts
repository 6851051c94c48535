import {
  closeSync,
  existsSync,
  fsyncSync,
  mkdirSync,
  openSync,
  readdirSync,
  renameSync,
  rmSync,
} from 'node:fs'
import { join } from 'node:path'
import { answersBeside, openAnswersFile } from '../database/answers/sqlite.ts'
import type { Database } from '../database/database.ts'
import { keepPublished } from '../questionnaires/answers-store.ts'

const kept = 7
const nightly = /^\d{4}-\d{2}-\d{2}\.db$/

const folderOf = (folder: string) => join(folder, 'backups')

/** Names of the nightly copies, the oldest first. */
export const nightliesIn = (folder: string): readonly string[] =>
  existsSync(folderOf(folder))
    ? readdirSync(folderOf(folder))
        .filter((name) => nightly.test(name))
        .toSorted()
    : []

/** Path of the newest nightly copy; null where there is none. */
export function lastBackup(folder: string): string | null {
  const name = nightliesIn(folder).at(-1)
  return name === undefined ? null : join(folderOf(folder), name)
}

/** Copies what is published of answers: rows that came since would say in two copies who gave them. */
async function copyAnswers({ answers }: Database, file: string): Promise<void> {
  await answers.copy!(file)
  const copied = openAnswersFile(file)
  await keepPublished(copied.db)
  await copied.vacuum()
  await copied.close()
}

/**
 * Copies a database that is in use, and beside it, as `….answers.db`, the answers to questionnaires. A file has its name once it
 * is complete and on the disk.
 */
export async function backup(database: Database, file: string): Promise<void> {
  const { backup: copy } = database
  if (!copy) throw new Error('PostgreSQL is copied by its own pg_dump.')
  await complete(answersBeside(file), (unfinished) => copyAnswers(database, unfinished))
  await complete(file, copy)
}

async function complete(file: string, write: (unfinished: string) => Promise<void>): Promise<void> {
  const unfinished = `${file}.unfinished`
  rmSync(unfinished, { force: true })
  await write(unfinished)
  const opened = openSync(unfinished, 'r+')
  fsyncSync(opened)
  closeSync(opened)
  renameSync(unfinished, file)
}

/** A copy beside the nightly ones. @returns its path */
export async function backupInto(folder: string, database: Database, name: string): Promise<string> {
  mkdirSync(folderOf(folder), { recursive: true })
  const file = join(folderOf(folder), `${name}.db`)
  await backup(database, file)
  return file
}

/** The copy of a day; of all of them the seven newest stay. @param day ISO day */
export async function nightlyBackup(folder: string, database: Database, day: string): Promise<void> {
  await backupInto(folder, database, day)
  for (const name of nightliesIn(folder).slice(0, -kept)) {
    const file = join(folderOf(folder), name)
    rmSync(answersBeside(file), { force: true })
    rmSync(file)
  }
}
