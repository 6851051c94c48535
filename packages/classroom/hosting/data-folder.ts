// The folder that holds everything of a server on SQLite: the database, its key, its backups and the list of deletions.
import { randomBytes } from 'node:crypto'
import { chmodSync, existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { migrateAnswers } from '../database/answers/migrate.ts'
import { answersBeside } from '../database/answers/sqlite.ts'
import type { Database } from '../database/database.ts'
import { codeOf } from '../database/errors.ts'
import { isSound } from '../database/sound.ts'
import { migrate, needsMigration, refuseNewer } from '../database/migrate.ts'
import { openSqlite } from '../database/sqlite.ts'
import { backupInto, lastBackup } from './backups.ts'

export const databaseIn = (folder: string): string => join(folder, 'botgarten.db')

/** The key of codes and pictures: made once, readable by its owner alone, in no backup. */
export function secretIn(folder: string): Uint8Array {
  mkdirSync(folder, { recursive: true })
  const file = join(folder, 'secret.key')
  if (!existsSync(file)) writeFileSync(file, randomBytes(32), { mode: 0o600, flag: 'wx' })
  return new Uint8Array(readFileSync(file))
}

type Opened =
  | { readonly kind: 'open'; readonly database: Database }
  /** A file was broken: it is kept under another name, and nothing was put in its place. */
  | { readonly kind: 'broken'; readonly aside: string; readonly lastBackup: string | null }

/**
 * Opens the database of a folder, and makes it where there is none. Before its tables change it is copied.
 * @throws the database's error where the file is sound and cannot be opened
 */
export async function openDataFolder(folder: string): Promise<Opened> {
  mkdirSync(folder, { recursive: true })
  const file = databaseIn(folder)
  const isNew = !existsSync(file)
  const broken = [file, answersBeside(file)].find((one) => existsSync(one) && !isSound(one))
  if (broken !== undefined)
    return { kind: 'broken', aside: setAside(broken, 'broken'), lastBackup: lastBackup(folder) }
  const database = openSqlite(file)
  try {
    for (const one of [file, answersBeside(file)]) forOwnerAlone(one)
    await refuseNewer(database)
    await migrateAnswers(database.answers)
    if (!isNew && (await needsMigration(database))) await backupInto(folder, database, 'before-migration')
    await migrate(database)
  } catch (error) {
    await database.close()
    throw error
  }
  return { kind: 'open', database }
}

/** Only the owner may read the file. A file of another user of this machine is not changed. */
function forOwnerAlone(file: string): void {
  try {
    chmodSync(file, 0o600)
  } catch (error) {
    if (codeOf(error) !== 'EPERM') throw error
  }
}

/** Renames a database with what belongs to it; an older one of that name stays. @returns the new name */
export function setAside(file: string, why: string): string {
  let count = 1
  while (existsSync(`${file}.${why}-${count}`)) count++
  const aside = `${file}.${why}-${count}`
  for (const end of ['', '-wal', '-shm']) {
    try {
      renameSync(file + end, aside + end)
    } catch (error) {
      if (codeOf(error) !== 'ENOENT') throw error
    }
  }
  return aside
}
