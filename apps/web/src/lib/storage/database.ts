import type { Project } from '@botgarten/programs'
import { openDB, type DBSchema, type IDBPDatabase } from 'idb'

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
}

interface Schema extends DBSchema {
  projects: { key: string; value: Kept }
  bin: { key: string; value: Thrown }
}

type Opened = IDBPDatabase<Schema>

/** One step a version: the first makes version 1 of nothing. What was shipped stays as it is. */
const migrations: readonly ((db: Opened) => void)[] = [
  (db) => void db.createObjectStore('projects', { keyPath: 'id' }),
  (db) => void db.createObjectStore('bin', { keyPath: 'id' }),
]

let opened: Promise<Opened> | undefined

const forget = () => (opened = undefined)

/** The database of this device. Rejects where the browser refuses; what is refused once may be allowed the next time. */
export function database(): Promise<Opened> {
  opened ??= openDB<Schema>('botgarten', migrations.length, {
    upgrade: (db, from) => migrations.slice(from).forEach((migrate) => migrate(db)),
    // A tab with a newer version waits: this one lets go, and asks anew with its next save.
    blocking: (_now, _wanted, event) => {
      ;(event.target as IDBDatabase).close()
      forget()
    },
    terminated: forget,
  })
  opened.catch(forget)
  return opened
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

/** `full`: no room left · `refused`: the device keeps nothing. */
export type Trouble = 'full' | 'refused'

/** What kept a write from happening. */
export function troubleOf(cause: unknown): Trouble {
  console.warn('This could not be kept on the device.', cause)
  return cause instanceof DOMException && cause.name === 'QuotaExceededError' ? 'full' : 'refused'
}
