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
import type { Database } from '../database/database.ts'

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

/** Copies a database that is in use. The file has its name once it is complete and on the disk. */
export async function backup(database: Database, file: string): Promise<void> {
  if (!database.backup) throw new Error('PostgreSQL is copied by its own pg_dump.')
  const unfinished = `${file}.unfinished`
  rmSync(unfinished, { force: true })
  await database.backup(unfinished)
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
  for (const name of nightliesIn(folder).slice(0, -kept)) rmSync(join(folderOf(folder), name))
}
