import { groupBy } from '@botgarten/browsers'
import { readPlan, type StudyPlan } from '@botgarten/experiments/study'
import { deleteDB, openDB, type DBSchema, type IDBPDatabase } from 'idb'
import * as v from 'valibot'
import { emptyBin, listBin } from './bin.ts'
import { storageErrorIn } from './database.ts'
import { list } from './projects.ts'
import { deleteProject } from './records.ts'
import { placeOfStudy } from './study-sign.ts'

/** A child that sits at this device now. */
export interface Sitting {
  readonly pseudonym: string
  readonly group: number
  readonly session: string
  /** Milliseconds since 1970; it never leaves the device. */
  readonly began: number
  /** Of the last line, in milliseconds since then: time never goes back in a log. */
  readonly last: number
  /** How many lines of its log are kept. */
  readonly lines: number
  /** Index of the module that is open. */
  readonly part: number
  /** Has it said yes to the log? */
  readonly yes: boolean
  /** Does it let the log rest? */
  readonly rests: boolean
  /** The page that was opened last, by its own random name: it alone writes. */
  readonly page: string
}

/** The study that is open on this device. */
export interface OpenStudy {
  readonly plan: StudyPlan
  /** The researcher has ticked the consent box, and handed the device out. */
  readonly ready: boolean
  readonly child: Sitting | null
}

const count = v.pipe(v.number(), v.integer(), v.minValue(0))
const kept = v.object({
  plan: v.pipe(
    v.unknown(),
    v.transform((plan) => readPlan(plan)),
  ),
  ready: v.boolean(),
  child: v.nullable(
    v.object({
      ...{
        pseudonym: v.string(),
        session: v.string(),
        group: count,
        began: count,
        last: count,
        part: count,
        lines: count,
      },
      ...{ yes: v.boolean(), rests: v.boolean(), page: v.string() },
    }),
  ),
})

/** The study of this device; null where none is open, or something lies there that is none. */
export function readStudy(): OpenStudy | null {
  try {
    const text = localStorage.getItem(placeOfStudy)
    return text === null ? null : v.parse(kept, JSON.parse(text))
  } catch {
    return null
  }
}

/** Keeps it; null ends it. False where this device keeps nothing. */
export function writeStudy(study: OpenStudy | null): boolean {
  try {
    if (study) localStorage.setItem(placeOfStudy, JSON.stringify(study))
    else localStorage.removeItem(placeOfStudy)
    return true
  } catch {
    return false
  }
}

/** A line of the log of this device. Kept twice it is one: its session and number name it. */
export interface LineRecord {
  readonly pseudonym: string
  readonly session: string
  /** When the session began, which puts sessions in order. */
  readonly began: number
  /** Its number in the session, from 0. */
  readonly n: number
  /** As it stands in the file. */
  readonly text: string
}

interface Schema extends DBSchema {
  lines: {
    key: [began: number, session: string, n: number]
    value: LineRecord
    indexes: { pseudonym: string }
  }
}

/** A database of its own: deleting it deletes every log. */
const name = 'botgarten-study'
let opened: Promise<IDBPDatabase<Schema>> | undefined

const database = () =>
  (opened ??= openDB<Schema>(name, 1, {
    upgrade(db) {
      const lines = db.createObjectStore('lines', { keyPath: ['began', 'session', 'n'] })
      lines.createIndex('pseudonym', 'pseudonym')
    },
    // Another tab deletes all of it: this one lets go.
    blocking: (_now, _wanted, event) => {
      ;(event.target as IDBDatabase).close()
      opened = undefined
    },
    terminated: () => (opened = undefined),
  }))

/** Puts lines into the log of this device. False where it could not keep them. */
export async function putLines(lines: readonly LineRecord[]): Promise<boolean> {
  try {
    const transaction = (await database()).transaction('lines', 'readwrite')
    await Promise.all([...lines.map((line) => transaction.store.put(line)), transaction.done])
    return true
  } catch (cause) {
    console.warn('A log cannot be kept on this device.', cause)
    return false
  }
}

/** A page that is left may not wait for a database: what is on its way lies here until the next page takes it up. */
const aside = 'botgarten.study-aside'

export function putAside(lines: readonly LineRecord[]): void {
  try {
    if (lines.length > 0) localStorage.setItem(aside, JSON.stringify(lines))
  } catch {
    // No room: the database may still have come first.
  }
}

const lineRecord = v.object({
  ...{ pseudonym: v.string(), session: v.string(), began: count, n: count, text: v.string() },
})

/** Takes up what the page before has left on its way. */
export async function takeAside(): Promise<void> {
  try {
    const text = localStorage.getItem(aside)
    if (text === null) return
    await putLines(v.parse(v.array(lineRecord), JSON.parse(text)))
    localStorage.removeItem(aside)
  } catch {
    // Something else lies there.
  }
}

/** How many lines and sessions there are of each pseudonym, in order of pseudonyms. */
export async function loggedHere(): Promise<
  readonly { pseudonym: string; lines: number; sessions: number }[]
> {
  await takeAside()
  const all = await (await database()).getAll('lines')
  return [...groupBy(all, ({ pseudonym }) => pseudonym)]
    .map(([pseudonym, own]) => ({
      ...{ pseudonym, lines: own.length },
      sessions: new Set(own.map(({ session }) => session)).size,
    }))
    .toSorted((a, b) => (a.pseudonym < b.pseudonym ? -1 : 1))
}

/** The log as a file: of one pseudonym, or of all. */
export async function logFile(pseudonym?: string): Promise<string> {
  await takeAside()
  const db = await database()
  const all = pseudonym ? await db.getAllFromIndex('lines', 'pseudonym', pseudonym) : await db.getAll('lines')
  return all.map(({ text }) => `${text}\n`).join('')
}

/** Begins the names of a child's projects on this device. */
export const projectsOf = (pseudonym: string): string => `study-${pseudonym}-`

/** Deletes all that this device holds of one pseudonym: its log, and its projects, those in the bin too. */
export async function deleteChild(pseudonym: string): Promise<void> {
  await takeAside()
  const db = await database()
  const transaction = db.transaction('lines', 'readwrite')
  const keys = await transaction.store.index('pseudonym').getAllKeys(pseudonym)
  await Promise.all([...keys.map((key) => transaction.store.delete(key)), transaction.done])
  await deleteProjects(projectsOf(pseudonym))
}

async function deleteProjects(beginning: string): Promise<void> {
  const { projects, damaged } = await list()
  const ids = [...projects, ...damaged].map(({ id }) => id).filter((id) => id.startsWith(beginning))
  await storageErrorIn(async (transaction) => {
    await Promise.all(ids.map((id) => deleteProject(transaction, id)))
  })
  const { thrown } = await listBin()
  await emptyBin(thrown.filter(({ was }) => was.startsWith(beginning)).map(({ id }) => id))
}

/** Deletes every log of this device. */
export async function deleteLogs(): Promise<void> {
  await takeAside()
  await opened?.then((db) => db.close()).catch(() => undefined)
  opened = undefined
  await deleteDB(name)
}
