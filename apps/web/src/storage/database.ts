import type { Project } from '@botgarten/programs'
import { deleteDB, openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction } from 'idb'
import { ownName } from './account.ts'

/** A project on this device. `revision` grows with every save, so that two tabs notice each other. */
export interface Kept {
  readonly id: string
  readonly project: Project
  /** Milliseconds since 1970. */
  readonly changed: number
  readonly revision: number
}

/** A project in the bin. `id` is a key of the bin; `was` is the key it had, and gets again where that is free. */
export interface Thrown {
  readonly id: string
  readonly was: string
  readonly project: Project
  readonly changed: number
  readonly revision: number
  /** When it was thrown away, in milliseconds since 1970. */
  readonly thrown: number
  /** On which day of use that was (days.ts). Versions 1 and 2 did not count them. */
  readonly day?: number
}

/**
 * A record of the store `projects`. Pictures and revision have records of their own, so that a save writes neither 5 MB nor
 * reads them. `pictures`: hashes of its pictures; what versions 1 and 2 have written has none, and holds both itself.
 */
export interface ProjectRecord {
  readonly id: string
  readonly project: Project
  readonly changed: number
  readonly pictures?: readonly string[]
  readonly revision?: number
}

interface PictureRecord {
  readonly project: string
  readonly hash: string
  readonly asset: Project['assets'][string]
}

/** A version as the class names it. After a restore two versions can have one number, but never one hash. */
export interface ClassVersion {
  readonly revision: number
  readonly hash: string
}

/** How a project stands to its class. Revisions of the class and those of the device are counted apart. */
export interface SyncRecord {
  readonly id: string
  /** Revision of the class that this device's project stands on; 0: the class has none. */
  readonly base: number
  /** Hash of that revision; none in records that are older than hashes. */
  readonly hash?: string | undefined
  /** Earlier versions of the class that this project was made from, the newest last. */
  readonly seen?: readonly ClassVersion[] | undefined
  /** Revision of this device that the class holds; 0: none. */
  readonly synced: number
  /** Revision of the class that came from another device: the child has not chosen yet. */
  readonly conflict?: number
  /** What the class does not take, and the revision of this device that it was. */
  readonly refused?: { readonly revision: number; readonly reason: string }
  /** It was thrown away on this device, and the class does not know yet. */
  readonly thrown?: true
  /** The version that was deleted, here and in the class. */
  readonly gone?: { readonly revision: number; readonly hash?: string | undefined }
}

/** A save on its way to the class: once begun, it stays as it is until the class has answered. */
export interface OutboxRecord {
  readonly id: string
  /** Sent twice under this name, it is one save. */
  readonly save: string
  /** Revision of this device that it holds. */
  readonly revision: number
  readonly base: number
  /** Hash of `base`. */
  readonly hash?: string | undefined
  readonly project: Project
}

interface Schema extends DBSchema {
  projects: { key: string; value: ProjectRecord }
  bin: { key: string; value: Thrown }
  revisions: { key: string; value: { readonly id: string; readonly revision: number } }
  pictures: { key: [project: string, hash: string]; value: PictureRecord }
  days: { key: string; value: { readonly id: string; readonly count: number; readonly last: string } }
  sync: { key: string; value: SyncRecord }
  outbox: { key: string; value: OutboxRecord }
  /** The newest mark of the class that this device saw. */
  mark: { key: string; value: { readonly id: 'mark'; readonly mark: string } }
}

type Opened = IDBPDatabase<Schema>
const allStores = ['projects', 'bin', 'revisions', 'pictures', 'days', 'sync', 'outbox', 'mark'] as const
type Store = (typeof allStores)[number]
export type Writing = IDBPTransaction<Schema, Store[], 'readwrite'>
export type Reading = IDBPTransaction<Schema, Store[], 'readonly'>

/** One step a version: the first makes version 1 of nothing. What was shipped stays as it is. */
const migrations: readonly ((db: Opened) => void)[] = [
  (db) => void db.createObjectStore('projects', { keyPath: 'id' }),
  (db) => void db.createObjectStore('bin', { keyPath: 'id' }),
  // Records of `projects` are split one by one, when they are opened.
  (db) => {
    db.createObjectStore('revisions', { keyPath: 'id' })
    db.createObjectStore('pictures', { keyPath: ['project', 'hash'] })
    db.createObjectStore('days', { keyPath: 'id' })
  },
  (db) => {
    db.createObjectStore('sync', { keyPath: 'id' })
    db.createObjectStore('outbox', { keyPath: 'id' })
  },
  (db) => void db.createObjectStore('mark', { keyPath: 'id' }),
]

/** So long another tab may hold on to an older database before this one says so, in milliseconds. */
const TIMEOUT = 3000

class BlockedError extends Error {
  override readonly name = 'BlockedError'
}

/** Of the device's database; each pupil has one of their own beside it. */
export const name = 'botgarten'
let opened: Promise<Opened> | undefined

const forget = () => (opened = undefined)

/** The database of this device. Rejects where the browser refuses; what is refused once may be allowed the next time. */
export function database(): Promise<Opened> {
  opened ??= open()
  opened.catch(forget)
  return opened
}

async function open(): Promise<Opened> {
  let giveUp: (error: Error) => void = () => {}
  const blocked = new Promise<never>((_, reject) => (giveUp = reject))
  const wait = () =>
    void setTimeout(() => giveUp(new BlockedError('An older tab holds the database.')), TIMEOUT)
  const asked = openDB<Schema>(ownName(name), migrations.length, {
    upgrade: (db, from) => migrations.slice(from).forEach((migrate) => migrate(db)),
    blocked: wait,
    // A tab with a newer version waits: this one lets go, and asks again with its next save.
    blocking: (_now, _wanted, event) => {
      ;(event.target as IDBDatabase).close()
      forget()
    },
    terminated: forget,
  })
  return Promise.race([asked, blocked])
}

/** Writes all of it, so that it survives a device that is switched off, or nothing. */
export async function writing<Result>(act: (transaction: Writing) => Promise<Result>): Promise<Result> {
  const transaction = (await database()).transaction([...allStores], 'readwrite', { durability: 'strict' })
  // Whatever stops it stops `act`, or is awaited below.
  transaction.done.catch(() => {})
  try {
    const result = await act(transaction)
    await transaction.done
    return result
  } catch (cause) {
    try {
      transaction.abort()
    } catch {
      // It has ended by itself.
    }
    throw cause
  }
}

/** Reads all stores as they are at one moment. */
export async function reading<Result>(act: (transaction: Reading) => Promise<Result>): Promise<Result> {
  const transaction = (await database()).transaction([...allStores])
  return act(transaction)
}

/** Does this browser keep anything at all? */
export async function keepsAnything(): Promise<boolean> {
  try {
    await database()
    return true
  } catch {
    return false
  }
}

/**
 * `full`: no room left · `refused`: the device keeps nothing · `outdated`: a newer Botgarten has been here, this page is to
 * be loaded again · `blocked`: a tab with an older one does not let go.
 */
export type StorageError = 'full' | 'refused' | 'outdated' | 'blocked'

const storageErrors: { readonly [name: string]: StorageError } = {
  QuotaExceededError: 'full',
  VersionError: 'outdated',
  BlockedError: 'blocked',
}

/** What kept a write from happening. */
export function storageErrorOf(cause: unknown): StorageError {
  console.warn('This could not be kept on the device.', cause)
  return (cause instanceof Error && storageErrors[cause.name]) || 'refused'
}

/** Writes, or says why that could not be. */
export async function tried<Result>(
  act: (transaction: Writing) => Promise<Result>,
): Promise<Result | { readonly kind: StorageError }> {
  try {
    return await writing(act)
  } catch (cause) {
    return { kind: storageErrorOf(cause) }
  }
}

/** Writes what is only asked whether it went well. */
export async function storageErrorIn(
  act: (transaction: Writing) => Promise<void>,
): Promise<StorageError | null> {
  try {
    await writing(act)
    return null
  } catch (cause) {
    return storageErrorOf(cause)
  }
}

/** Deletes what the class has of the pupil whose page this is. Its bin waits for the child to come back. */
export async function deleteSent(): Promise<void> {
  const binned = await writing(async (transaction) => {
    const sent = allStores.filter((store) => store !== 'bin' && store !== 'days')
    await Promise.all(sent.map((store) => transaction.objectStore(store).clear()))
    return transaction.objectStore('bin').count()
  })
  if (binned === 0) await deleteOwnDatabase()
}

/** Deletes everything of the pupil whose page this is. Other tabs let go of it when they are asked. */
export async function deleteOwnDatabase(): Promise<void> {
  const own = ownName(name)
  if (own === name) return
  await opened?.then((db) => db.close()).catch(() => undefined)
  forget()
  await deleteDB(own).catch((cause: unknown) => console.warn('A database cannot be deleted.', cause))
}
