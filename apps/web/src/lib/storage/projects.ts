import type { Project } from '@botgarten/programs'
import { openDB, type DBSchema, type IDBPDatabase } from 'idb'

/** A project on this device. `revision` grows by one with every save, so that two tabs notice each other. */
export interface Kept {
  readonly id: string
  readonly project: Project
  /** Milliseconds since 1970. */
  readonly changed: number
  readonly revision: number
}

/** `newer`: another tab has saved meanwhile · `full`: no room left · `refused`: the device keeps nothing. */
export type Saved =
  { readonly kind: 'saved'; readonly revision: number } | { readonly kind: 'newer' | 'full' | 'refused' }

interface Schema extends DBSchema {
  projects: { key: string; value: Kept }
}

let opened: Promise<IDBPDatabase<Schema>> | undefined

const forget = () => (opened = undefined)

function database(): Promise<IDBPDatabase<Schema>> {
  opened ??= openDB<Schema>('botgarten', 1, {
    upgrade: (db) => void db.createObjectStore('projects', { keyPath: 'id' }),
    terminated: forget,
  })
  // What is refused once may be allowed the next time.
  opened.catch(forget)
  return opened
}

/** One project, or null where there is none or the device refuses. */
export async function load(id: string): Promise<Kept | null> {
  try {
    return (await (await database()).get('projects', id)) ?? null
  } catch (cause) {
    console.warn('Projects cannot be read on this device.', cause)
    return null
  }
}

/** All projects, the last changed first. */
export async function list(): Promise<readonly Kept[]> {
  try {
    const all = await (await database()).getAll('projects')
    return all.sort((a, b) => b.changed - a.changed)
  } catch (cause) {
    console.warn('Projects cannot be read on this device.', cause)
    return []
  }
}

/** Saves unless somebody else has saved since `basedOn` (0: it is new). Reading and writing are one transaction. */
export async function save(id: string, project: Project, basedOn: number): Promise<Saved> {
  try {
    const transaction = (await database()).transaction('projects', 'readwrite', { durability: 'strict' })
    const found = await transaction.store.get(id)
    if ((found?.revision ?? 0) !== basedOn) return { kind: 'newer' }
    const revision = basedOn + 1
    // Strings and plain objects only; a proxy or a function here would be a mistake of ours.
    await transaction.store.put({ id, project, changed: Date.now(), revision })
    await transaction.done
    announce(id, revision)
    return { kind: 'saved', revision }
  } catch (cause) {
    console.warn('The project could not be saved.', cause)
    return { kind: cause instanceof DOMException && cause.name === 'QuotaExceededError' ? 'full' : 'refused' }
  }
}

const channel = typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel('botgarten-projects')

const announce = (id: string, revision: number) => channel?.postMessage({ id, revision })

/** Calls back when another tab has saved a project. Returns how to stop. */
export function whenSavedElsewhere(id: string, heard: (revision: number) => void): () => void {
  const listen = ({ data }: MessageEvent<{ id: string; revision: number }>) => {
    if (data.id === id) heard(data.revision)
  }
  channel?.addEventListener('message', listen)
  return () => channel?.removeEventListener('message', listen)
}

/** A key for a project that has none yet; safe in an address. */
export function freshId(card: string): string {
  const bytes = crypto.getRandomValues(new Uint32Array(2))
  return `${card}-${[...bytes].map((part) => part.toString(36)).join('')}`
}
