// Copies of a server's data within its data folder, and when they are deleted: by age, so that deleted classes and pupils
// disappear from the copies, too.
import { existsSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import * as v from 'valibot'
import { answersBeside } from '../database/answers/sqlite.ts'
import { lastBackup, nightliesIn, nightlyBackup, type Stored } from './backups.ts'

/** A copy is deleted this many days after the server first saw it. */
export const daysOfCopies = 7
const mostNightlies = 7

/** Names in `backups/`: nightly copies and the one before tables change, with those of earlier versions. */
const inBackups = /^(?:(?:\d{6}-)?\d{4}-\d{2}-\d{2}|before-migration)\.(?:age|db|answers\.db)$/
/** Databases, journals and keys that a restore has replaced. */
const replaced = /\.before-restore-\d+(?:-wal|-shm)?$/
/** Databases that were damaged and set aside, and no backup was restored since. */
const broken = /^[^.]+\.db\.broken-\d+$/

const filesIn = (folder: string) => (existsSync(folder) ? readdirSync(folder).toSorted() : [])

/** The copies that are deleted by age: paths within the data folder. */
const copiesIn = (folder: string): readonly string[] => [
  ...filesIn(folder).filter((name) => replaced.test(name)),
  ...filesIn(join(folder, 'backups'))
    .filter((name) => inBackups.test(name))
    .map((name) => `backups/${name}`),
]

/** The copies of a data folder that are no nightly ones, by name. */
export function otherCopiesIn(folder: string) {
  const nightlies = new Set(nightliesIn(folder).flatMap(({ file }) => [file, answersBeside(file)]))
  return {
    byAge: copiesIn(folder).filter((name) => !nightlies.has(join(folder, name))),
    /** They stay until a backup is restored. */
    broken: filesIn(folder).filter((name) => broken.test(name)),
  }
}

const isoDay = v.pipe(v.string(), v.isoDate())
/** On which day each copy was first seen: the time of a file changes when it is moved or the clock is wrong. */
const ledgerOf = v.object({ day: isoDay, seen: v.record(v.string(), isoDay) })
type Ledger = v.InferOutput<typeof ledgerOf>

const fileOf = (folder: string) => join(folder, 'copies.json')

function readLedger(folder: string): Ledger {
  try {
    return v.parse(ledgerOf, JSON.parse(readFileSync(fileOf(folder), 'utf8')))
  } catch {
    // None yet, or not readable: all copies count as new.
    return { day: '0000-01-01', seen: {} }
  }
}

function writeLedger(folder: string, ledger: Ledger): void {
  const file = fileOf(folder)
  writeFileSync(`${file}.next`, JSON.stringify(ledger, null, 2), { mode: 0o600 })
  renameSync(`${file}.next`, file)
}

/** A copy was just made: the age of a deleted one of the same name does not count for it. */
export function forgetCopy(folder: string, name: string): void {
  const { day, seen } = readLedger(folder)
  if (!(name in seen)) return
  const { [name]: _, ...others } = seen
  writeLedger(folder, { day, seen: others })
}

export interface Pruning {
  /** Today, an ISO day. */
  readonly day: string
  /** The day `daysOfCopies` ago: copies of that day and older ones are deleted. */
  readonly oldest: string
  /** The calendar day may be wrong: nothing is deleted. */
  readonly clockDoubted: boolean
}

/** A day cannot lie after today, except that the clock was ahead when it was noted. */
function firstSeen({ day, seen }: Ledger, name: string, today: Pruning): readonly [string, string][] {
  const noted = seen[name]
  if (today.clockDoubted) {
    // A clock that went back does not know how old a copy is.
    const known = noted ?? (today.day < day ? undefined : today.day)
    return known === undefined ? [] : [[name, known]]
  }
  return [[name, noted === undefined || noted > today.day ? today.day : noted]]
}

/**
 * Deletes the copies that are a week old, and of nightly ones all but the seven newest. The newest nightly copy stays, however
 * old: each was read back before it got its name, so it goes when there is a newer one. Call it after a backup and at each start.
 */
export function pruneCopies(folder: string, today: Pruning): void {
  const copies = copiesIn(folder)
  const ledger = readLedger(folder)
  if (copies.length === 0 && Object.keys(ledger.seen).length === 0) return
  const seen = copies.flatMap((name) => firstSeen(ledger, name, today))
  if (today.clockDoubted) return writeLedger(folder, { day: ledger.day, seen: Object.fromEntries(seen) })
  const old = new Set(oldOnes(folder, seen, today.oldest))
  for (const name of old) rmSync(join(folder, name), { force: true })
  writeLedger(folder, {
    day: today.day,
    seen: Object.fromEntries(seen.filter(([name]) => !old.has(name))),
  })
}

function oldOnes(folder: string, seen: readonly (readonly [string, string])[], oldest: string) {
  const withAnswers = (files: readonly { readonly file: string }[]) =>
    new Set(files.flatMap(({ file }) => [file, answersBeside(file)]))
  const last = lastBackup(folder)
  const newest = withAnswers(last === null ? [] : [last])
  const tooMany = withAnswers(nightliesIn(folder).slice(0, -mostNightlies))
  return seen
    .map(([name, day]) => ({ name, day, path: join(folder, name) }))
    .filter(({ path, day }) => !newest.has(path) && (day <= oldest || tooMany.has(path)))
    .map(({ name }) => name)
}

/** Makes the copy of today where there is none, and deletes the old ones also where that fails, for example on a full disk. */
export async function renewCopies(stored: Stored & Pruning): Promise<void> {
  try {
    if (lastBackup(stored.folder)?.day !== stored.day) await nightlyBackup(stored)
  } finally {
    pruneCopies(stored.folder, stored)
  }
}
