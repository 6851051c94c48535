// The folder that holds everything of a server on SQLite: the database, its key, its backups and the list of deletions.
import { randomBytes } from 'node:crypto'
import { chmodSync, existsSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { migrateAnswers } from '../database/answers/migrate.ts'
import { answersBeside } from '../database/answers/sqlite.ts'
import type { Database } from '../database/database.ts'
import { codeOf } from '../database/errors.ts'
import { isSound } from '../database/sound.ts'
import { migrate, needsMigration, refuseNewer } from '../database/migrate.ts'
import { openSqlite } from '../database/sqlite.ts'
import { backupInto, lastBackup, removeUnfinished, type Stored } from './backups.ts'
import { forgetCopy } from './copies.ts'

export const databaseIn = (folder: string): string => join(folder, 'botgarten.db')

/** The key of codes, pictures and the passphrase of backups: made once, readable by its owner alone. */
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

/** For the copy that is made before tables change. */
export interface Opening {
  readonly secret: Uint8Array
  /** Today, an ISO day. */
  readonly day: string
}

/**
 * Opens the database of a folder, and makes it where there is none. Before its tables change it is copied.
 * @throws the database's error where the file is sound and cannot be opened
 */
export async function openDataFolder(folder: string, opening: Opening): Promise<Opened> {
  mkdirSync(folder, { recursive: true })
  const file = databaseIn(folder)
  const isNew = !existsSync(file)
  const broken = [file, answersBeside(file)].find((one) => existsSync(one) && !isSound(one))
  if (broken !== undefined)
    return { kind: 'broken', aside: setAside(broken, 'broken'), lastBackup: lastBackup(folder)?.file ?? null }
  const database = openSqlite(file)
  try {
    for (const one of [file, answersBeside(file)]) forOwnerAlone(one)
    await refuseNewer(database)
    await migrateAnswers(database.answers)
    removeUnfinished(folder)
    if (!isNew && (await needsMigration(database)))
      await copyBeforeMigration({ database, folder, ...opening })
    await migrate(database)
  } catch (error) {
    await database.close()
    throw error
  }
  return { kind: 'open', database }
}

const beforeMigration = 'before-migration'

async function copyBeforeMigration(stored: Stored): Promise<void> {
  await backupInto(stored, beforeMigration)
  forgetCopy(stored.folder, `backups/${beforeMigration}.age`)
  // Earlier versions wrote it without encryption.
  for (const end of ['db', 'answers.db'])
    rmSync(join(stored.folder, 'backups', `${beforeMigration}.${end}`), { force: true })
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
    forgetCopy(dirname(file), basename(aside + end))
  }
  return aside
}
