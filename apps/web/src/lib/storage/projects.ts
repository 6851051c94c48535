import type { Project } from '@botgarten/programs'
import { announce } from './channel.ts'
import { database, troubleOf, type Kept, type Trouble } from './database.ts'

/** `newer`: another tab has saved meanwhile · `gone`: another tab has thrown it away. */
export type Saved =
  { readonly kind: 'saved'; readonly revision: number } | { readonly kind: 'newer' | 'gone' | Trouble }

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

/**
 * A revision for a project that has none yet: a moment. A key that is used anew after the bin never comes back to a
 * revision that an old tab still holds.
 */
export const firstRevision = (): number => Date.now()

/** Saves unless somebody else has saved since `basedOn` (0: it is new). Reading and writing are one transaction. */
export async function save(id: string, project: Project, basedOn: number): Promise<Saved> {
  try {
    const transaction = (await database()).transaction('projects', 'readwrite', { durability: 'strict' })
    const found = await transaction.store.get(id)
    if (basedOn > 0 && !found) return { kind: 'gone' }
    if ((found?.revision ?? 0) !== basedOn) return { kind: 'newer' }
    const revision = found ? found.revision + 1 : firstRevision()
    // Strings and plain objects only; a proxy or a function here would be a mistake of ours.
    await transaction.store.put({ id, project, changed: Date.now(), revision })
    await transaction.done
    announce({ kind: 'saved', id, revision })
    return { kind: 'saved', revision }
  } catch (cause) {
    return { kind: troubleOf(cause) }
  }
}

/** Gives a project another name and leaves the rest as whoever saved last has left it. */
export async function rename(id: string, name: string): Promise<Saved> {
  try {
    const transaction = (await database()).transaction('projects', 'readwrite', { durability: 'strict' })
    const found = await transaction.store.get(id)
    if (!found) return { kind: 'gone' }
    const revision = found.revision + 1
    await transaction.store.put({ ...found, project: { ...found.project, name }, revision })
    await transaction.done
    announce({ kind: 'saved', id, revision, name })
    return { kind: 'saved', revision }
  } catch (cause) {
    return { kind: troubleOf(cause) }
  }
}

/** Keeps projects under keys that are free. All of them, or none. */
export async function add(projects: readonly Omit<Kept, 'revision'>[]): Promise<Trouble | null> {
  try {
    const transaction = (await database()).transaction('projects', 'readwrite', { durability: 'strict' })
    const revision = firstRevision()
    await Promise.all(projects.map((one) => transaction.store.add({ ...one, revision })))
    await transaction.done
    return null
  } catch (cause) {
    return troubleOf(cause)
  }
}

/** A key for a project that has none yet; safe in an address. */
export function freshId(card: string): string {
  const bytes = crypto.getRandomValues(new Uint32Array(2))
  return `${card}-${[...bytes].map((part) => part.toString(36)).join('')}`
}
