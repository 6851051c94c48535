import { refusalOf, type Project, type ProjectError } from '@botgarten/programs/project'
import { database, reading, tried, storageErrorIn, type Kept, type StorageError } from './database.ts'
import {
  firstRevision,
  getProject,
  isWhole,
  momentOf,
  putProject,
  readRecords,
  savedRevision,
  type Damaged,
} from './records.ts'

/**
 * `newer`: another tab has saved meanwhile · `gone`: another tab has thrown it away · `tooMuch`: it could not be opened
 * again, and what was saved before stays.
 */
export type Saved =
  | { readonly kind: 'saved'; readonly revision: number }
  | { readonly kind: 'newer' | 'gone' | StorageError }
  | { readonly kind: 'tooMuch'; readonly refusal: ProjectError }

/** Projects in a list, without their pictures. */
export type Listed = Omit<Kept, 'revision'>

/** All projects of this device, the last changed first, and what of them cannot be read. */
export interface Shelved {
  readonly projects: readonly Listed[]
  readonly damaged: readonly Damaged[]
}

/** One project with its pictures, or null where there is none or the device refuses. Nothing of it is trusted. */
export async function load(id: string): Promise<Kept | null> {
  try {
    const [record, found] = await reading(async (transaction) => [
      await transaction.objectStore('projects').get(id),
      await getProject(transaction, id),
    ])
    if (record && isWhole(record)) await split(id)
    return found
  } catch (cause) {
    console.warn('Projects cannot be read on this device.', cause)
    return null
  }
}

/** One project, read as carefully as a stranger's file; null where there is none that can be read. */
export async function open(id: string): Promise<Kept | null> {
  const found = await load(id)
  return (found && readRecords([found]).read[0]) ?? null
}

/** Gives pictures and revision of an older record records of their own. Where that fails it stays as it is. */
async function split(id: string): Promise<void> {
  await storageErrorIn(async (transaction) => {
    const found = await getProject(transaction, id)
    if (found) await putProject(transaction, found)
  })
}

/** All projects. Each is read alone: one that is damaged keeps no other out. */
export const list = (): Promise<Shelved> => shelved(async () => (await database()).getAll('projects'))

/** The same with all their pictures. */
export const listWhole = (): Promise<Shelved> =>
  shelved(() =>
    reading(async (transaction) => {
      const ids = await transaction.objectStore('projects').getAllKeys()
      const all = await Promise.all(ids.map((id) => getProject(transaction, id)))
      return all.filter((one) => one !== null)
    }),
  )

async function shelved(records: () => Promise<readonly Listed[]>): Promise<Shelved> {
  try {
    const { read, damaged } = readRecords(await records())
    const projects = read.map(({ id, project, changed }) => ({ id, project, changed: momentOf(changed) }))
    return { projects: projects.sort(lastFirst), damaged: damaged.sort(lastFirst) }
  } catch (cause) {
    console.warn('Projects cannot be read on this device.', cause)
    return { projects: [], damaged: [] }
  }
}

const lastFirst = (a: { readonly changed: number }, b: { readonly changed: number }) => b.changed - a.changed

/** A picture of a project; undefined where there is none. */
export async function loadPicture(id: string, hash: string): Promise<Project['assets'][string] | undefined> {
  try {
    return (await (await database()).get('pictures', [id, hash]))?.asset
  } catch (cause) {
    console.warn('A picture cannot be read on this device.', cause)
    return undefined
  }
}

/** Saves unless somebody else has saved since `basedOn` (0: it is new). Reading and writing are one transaction. */
export async function save(id: string, project: Project, basedOn: number): Promise<Saved> {
  const refusal = refusalOf(project)
  if (refusal) return { kind: 'tooMuch', refusal }
  return tried(async (transaction): Promise<Saved> => {
    const found = await savedRevision(transaction, id)
    if (basedOn > 0 && found === null) return { kind: 'gone' }
    if ((found ?? 0) !== basedOn) return { kind: 'newer' }
    const revision = found === null ? firstRevision() : found + 1
    await putProject(transaction, { id, project, changed: Date.now(), revision })
    return { kind: 'saved', revision }
  })
}

/** Gives a project another name and leaves the rest as whoever saved last has left it. */
export async function rename(id: string, name: string): Promise<Saved> {
  return tried(async (transaction): Promise<Saved> => {
    const found = await getProject(transaction, id)
    if (!found) return { kind: 'gone' }
    const project = { ...found.project, name }
    const refusal = refusalOf(project)
    if (refusal) return { kind: 'tooMuch', refusal }
    const revision = found.revision + 1
    await putProject(transaction, { ...found, project, revision }, name)
    return { kind: 'saved', revision }
  })
}

/** Keeps projects under keys that are free. All of them, or none. */
export async function add(projects: readonly Listed[]): Promise<StorageError | null> {
  return storageErrorIn(async (transaction) => {
    const revision = firstRevision()
    for (const one of projects) {
      if ((await savedRevision(transaction, one.id)) !== null) throw new Error(`${one.id} is taken.`)
      await putProject(transaction, { ...one, revision })
    }
  })
}

/** A key for a project that has none yet; safe in an address. */
export function freshId(card: string): string {
  const bytes = crypto.getRandomValues(new Uint32Array(2))
  return `${card}-${[...bytes].map((part) => part.toString(36)).join('')}`
}
