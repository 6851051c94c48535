import { copyFileSync, existsSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { answersBeside } from '../database/answers/sqlite.ts'
import { NewerData, refuseNewer } from '../database/migrate.ts'
import { isSound } from '../database/sound.ts'
import { openSqlite } from '../database/sqlite.ts'
import { forgetClass } from '../questionnaires/askings-store.ts'
import { carryOut } from '../teaching/deleting-store.ts'
import { makeUnfinished, parts } from './backups.ts'
import { otherCopiesIn } from './copies.ts'
import { databaseIn, openDataFolder, setAside, type Opening } from './data-folder.ts'
import { isKeyOf } from './key-store.ts'
import { isSealed, openSealed } from './sealed-file.ts'
import { addTombstones, buriedIn, readTombstones, tombstonesIn } from './tombstones.ts'

export interface Restoring {
  /** Today, an ISO day. */
  readonly day: string
  /** The passphrase of an encrypted backup; null for a copy of the database (`….db`). */
  readonly phrase: string | null
  /** Path of another machine's list of deletions (`deleted.jsonl`); null for none. */
  readonly deleted?: string | null
}

interface Done {
  readonly kind: 'restored'
  /** New path of the previous database; null if there was none. */
  readonly before: string | null
  /** The folder or the caller has no list of deletions: those after the backup are not known. */
  readonly deletionsUnknown: boolean
  /** ISO day of the backup; null for a copy of the database. */
  readonly day: string | null
}

type Refused = {
  readonly kind:
    /** Damaged, or something else. */
    | 'notABackup'
    /** Encrypted, and no passphrase was given. */
    | 'phraseNeeded'
    | 'wrongPhrase'
    /** Cut off, or changed after it was made. */
    | 'damaged'
    /** A later version of the program has made it. */
    | 'newer'
    /** Its key is neither in the folder nor next to it. */
    | 'otherKey'
}
type Restored = Done | Refused

/** The files of a backup, in a folder of their own. */
interface Unpacked {
  readonly kind: 'unpacked'
  readonly secret: Uint8Array
  /** Its list of deletions. */
  readonly tombstones: string
  readonly hasAnswers: boolean
  readonly day: string | null
}

/**
 * Replaces the database by a backup while no server uses it; the database of before stays under another name. A backup
 * that cannot be used replaces nothing. Classes and pupils that were deleted after the backup are deleted again at once.
 */
export async function restore(folder: string, backup: string, restoring: Restoring): Promise<Restored> {
  if (!existsSync(backup)) return { kind: 'notABackup' }
  const into = makeUnfinished(folder)
  try {
    const unpacked = (await isSealed(backup))
      ? await unpackSealed(backup, restoring.phrase, into)
      : await takePair(folder, backup, into)
    if (unpacked.kind !== 'unpacked') return unpacked
    const isUsable = await examine(into, unpacked.secret)
    if (isUsable !== 'usable') return { kind: isUsable }
    return await putInPlace({ folder, into, unpacked, restoring })
  } finally {
    rmSync(into, { recursive: true, force: true })
  }
}

async function unpackSealed(
  backup: string,
  phrase: string | null,
  into: string,
): Promise<Unpacked | Refused> {
  if (phrase === null) return { kind: 'phraseNeeded' }
  const opened = await openSealed(backup, phrase, into)
  if (opened.kind !== 'opened') return opened
  if (![parts.database, parts.key].every((name) => opened.names.includes(name))) return { kind: 'notABackup' }
  const tombstones = opened.names.includes(parts.tombstones)
    ? readFileSync(join(into, parts.tombstones), 'utf8')
    : ''
  const secret = new Uint8Array(readFileSync(join(into, parts.key)))
  const hasAnswers = opened.names.includes(parts.answers)
  return { kind: 'unpacked', secret, tombstones, hasAnswers, day: opened.day }
}

/** A copy of the database of an earlier version with, next to it, its answers and the key; or with the key of the folder. */
async function takePair(folder: string, backup: string, into: string): Promise<Unpacked | Refused> {
  if (!isSound(backup)) return { kind: 'notABackup' }
  const database = join(into, parts.database)
  copyFileSync(backup, database)
  const answers = answersBeside(backup)
  const hasAnswers = existsSync(answers) && isSound(answers)
  if (hasAnswers) copyFileSync(answers, answersBeside(database))
  for (const place of [folder, dirname(backup), dirname(dirname(backup))]) {
    const file = join(place, parts.key)
    if (!existsSync(file)) continue
    const secret = new Uint8Array(readFileSync(file))
    if (await belongs(database, secret))
      return { kind: 'unpacked', secret, tombstones: '', hasAnswers, day: null }
  }
  return { kind: 'otherKey' }
}

async function belongs(file: string, secret: Uint8Array): Promise<boolean> {
  const database = openSqlite(file)
  try {
    return await isKeyOf(database, secret)
  } finally {
    await database.close()
  }
}

/** Can this version read the database in a folder, and does the key belong to it? */
async function examine(folder: string, secret: Uint8Array): Promise<'usable' | Refused['kind']> {
  const file = join(folder, parts.database)
  if (![file, answersBeside(file)].every((one) => !existsSync(one) || isSound(one))) return 'damaged'
  const database = openSqlite(file)
  try {
    await refuseNewer(database)
    return (await isKeyOf(database, secret)) ? 'usable' : 'otherKey'
  } catch (error) {
    if (error instanceof NewerData) return 'newer'
    throw error
  } finally {
    await database.close()
  }
}

interface Placing {
  readonly folder: string
  readonly into: string
  readonly unpacked: Unpacked
  readonly restoring: Restoring
}

async function putInPlace({ folder, into, unpacked, restoring }: Placing): Promise<Restored> {
  const { deleted = null, day } = restoring
  const deletionsUnknown = deleted === null && tombstonesIn(folder) === ''
  const file = databaseIn(folder)
  const before = existsSync(file) ? setAside(file, 'before-restore') : null
  const answers = answersBeside(file)
  if (unpacked.hasAnswers && existsSync(answers)) setAside(answers, 'before-restore')
  putKey(folder, unpacked.secret)
  if (unpacked.hasAnswers) renameSync(join(into, parts.answers), answers)
  renameSync(join(into, parts.database), file)
  const lists = [unpacked.tombstones, deleted === null ? '' : readFileSync(deleted, 'utf8')]
  addTombstones(folder, lists.flatMap(readTombstones))
  await deleteAgain(folder, { secret: unpacked.secret, day })
  // Damaged databases have stayed until now. From here on they are deleted by age, as replaced databases are.
  for (const name of otherCopiesIn(folder).broken) setAside(join(folder, name), 'before-restore')
  return { kind: 'restored', before, deletionsUnknown, day: unpacked.day }
}

/** The key of the backup; another one of the folder is renamed. */
function putKey(folder: string, secret: Uint8Array): void {
  const file = join(folder, parts.key)
  if (existsSync(file)) {
    if (readFileSync(file).equals(secret)) return
    setAside(file, 'before-restore')
  }
  writeFileSync(file, secret, { mode: 0o600, flag: 'wx' })
}

async function deleteAgain(folder: string, opening: Opening): Promise<void> {
  const opened = await openDataFolder(folder, opening)
  if (opened.kind === 'broken') throw new Error('A database that was sound is broken now.')
  const { db, answers } = opened.database
  try {
    for (const tombstone of buriedIn(folder)) {
      if (tombstone.kind === 'class') await forgetClass(answers.db, tombstone.id)
      await db.transaction().execute((inside) => carryOut(inside, tombstone))
    }
  } finally {
    await opened.database.close()
  }
}
