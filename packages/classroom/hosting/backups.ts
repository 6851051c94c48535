import {
  closeSync,
  copyFileSync,
  existsSync,
  fsyncSync,
  mkdirSync,
  mkdtempSync,
  openSync,
  readdirSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { answersBeside, openAnswersFile } from '../database/answers/sqlite.ts'
import type { Database } from '../database/database.ts'
import { keepPublished } from '../questionnaires/answers-store.ts'
import { phraseOf } from './phrase-store.ts'
import { isReadable } from './read-back.ts'
import { writeSealed } from './sealed-file.ts'
import { tombstonesIn } from './tombstones.ts'

/** Names of the parts of a backup. */
export const parts = {
  database: 'botgarten.db',
  answers: 'answers.db',
  key: 'secret.key',
  tombstones: 'deleted.jsonl',
} as const

/** `000012-2026-11-28.age`: the number orders the copies, since clocks are wrong at times. Earlier versions wrote `2026-11-28.db`. */
const nightly = /^(?:(\d{6})-)?(\d{4}-\d{2}-\d{2})\.(?:age|db)$/

export interface Nightly {
  readonly file: string
  /** ISO day by the clock of the server. */
  readonly day: string
  readonly number: number
}

const folderOf = (folder: string) => join(folder, 'backups')
const filesIn = (folder: string) => (existsSync(folderOf(folder)) ? readdirSync(folderOf(folder)) : [])

function nightlyOf(folder: string, name: string): readonly Nightly[] {
  const [, number = '0', day] = nightly.exec(name) ?? []
  return day === undefined ? [] : [{ file: join(folderOf(folder), name), day, number: Number(number) }]
}

/** The nightly copies, the oldest first. */
export const nightliesIn = (folder: string): readonly Nightly[] =>
  filesIn(folder)
    .toSorted()
    .flatMap((name) => nightlyOf(folder, name))
    .toSorted((one, other) => one.number - other.number)

/** The newest nightly copy; null before the first one. */
export const lastBackup = (folder: string): Nightly | null => nightliesIn(folder).at(-1) ?? null

/** Copies what is published of answers: rows that came since would say in two copies who gave them. */
async function copyAnswers({ answers }: Database, file: string): Promise<void> {
  await answers.copy!(file)
  const copied = openAnswersFile(file)
  await keepPublished(copied.db)
  await copied.vacuum()
  await copied.close()
}

/** A server whose backup is made. */
export interface Stored {
  readonly database: Database
  /** The server's key. */
  readonly secret: Uint8Array
  /** The data folder. */
  readonly folder: string
  /** Today, an ISO day. */
  readonly day: string
}

const unfinished = 'unfinished-'

/** A new folder for parts that are not encrypted. The caller removes it. */
export function makeUnfinished(folder: string): string {
  mkdirSync(folderOf(folder), { recursive: true, mode: 0o700 })
  return mkdtempSync(join(folderOf(folder), unfinished))
}

/** Removes the folders of backups and restores that were interrupted. */
export function removeUnfinished(folder: string): void {
  for (const name of filesIn(folder).filter((one) => one.startsWith(unfinished)))
    rmSync(join(folderOf(folder), name), { recursive: true })
}

/**
 * Copies a database that is in use into one encrypted file: the database, what is published of the answers, the key of codes
 * and pictures, and the list of deletions. A file has its name once it is on the disk and was read back from it.
 * @throws Error on PostgreSQL, which has pg_dump, and where the file cannot be read back
 */
export async function backup(stored: Stored, file: string, readBack = isReadable): Promise<void> {
  const { database, secret, folder, day } = stored
  if (!database.backup) throw new Error('PostgreSQL is copied by its own pg_dump.')
  const making = makeUnfinished(folder)
  try {
    const [copy, key] = [join(making, parts.database), join(making, parts.key)]
    const phrase = await phraseOf(database, secret)
    await copyAnswers(database, answersBeside(copy))
    await database.backup(copy)
    writeFileSync(key, secret, { mode: 0o600 })
    const deleted = join(making, parts.tombstones)
    writeFileSync(deleted, tombstonesIn(folder), { mode: 0o600 })
    const sealed = join(making, basename(file))
    await writeSealed(sealed, [copy, answersBeside(copy), key, deleted], { day, phrase })
    synced(sealed)
    if (!(await readBack(sealed, phrase))) throw new Error('The backup cannot be read back.')
    moveTo(file, sealed)
  } finally {
    rmSync(making, { recursive: true, force: true })
  }
}

function moveTo(file: string, sealed: string): void {
  try {
    renameSync(sealed, file)
  } catch (error) {
    if ((error as { code?: string }).code !== 'EXDEV') throw error
    // Another disk, such as a stick.
    const next = join(dirname(file), `${basename(file)}.unfinished`)
    copyFileSync(sealed, next)
    synced(next)
    renameSync(next, file)
  }
}

function synced(file: string): void {
  const opened = openSync(file, 'r+')
  fsyncSync(opened)
  closeSync(opened)
}

/** A copy next to the nightly ones. @returns its path */
export async function backupInto(stored: Stored, name: string): Promise<string> {
  const file = join(folderOf(stored.folder), `${name}.age`)
  await backup(stored, file)
  return file
}

/** The copy of today; an earlier one of the same day goes once this one is complete. */
export async function nightlyBackup(stored: Stored): Promise<void> {
  const last = lastBackup(stored.folder)
  const number = (last?.number ?? 0) + 1
  await backupInto(stored, `${String(number).padStart(6, '0')}-${stored.day}`)
  if (last?.day !== stored.day) return
  rmSync(answersBeside(last.file), { force: true })
  rmSync(last.file)
}
