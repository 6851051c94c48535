import { parseProject, ProjectError, type Project } from '@botgarten/programs/project'
import { announce, type News } from './channel.ts'
import type { Kept, ProjectRecord, Reading, Writing } from './database.ts'

// A project and the records that it is made of. Everything that is read here may be damaged.

/** A record that cannot be read. `raw`: what lies there, to be saved as a file. */
export interface Damaged {
  readonly id: string
  readonly name: string | null
  readonly changed: number
  readonly raw: unknown
}

const isObject = (value: unknown): value is { readonly [key: string]: unknown } =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

/** Anything but a moment counts as long ago. */
export const momentOf = (value: unknown): number =>
  typeof value === 'number' && value >= 0 && value <= 8.64e15 ? value : 0

const revisionOf = (value: unknown): number =>
  typeof value === 'number' && Number.isSafeInteger(value) && value > 0 ? value : 1

/**
 * A revision for a project that has none yet: a moment. A key that is used again after the bin never comes back to a
 * revision that an old tab still holds.
 */
export const firstRevision = (): number => Date.now()

/** Does it hold its pictures and its revision itself, as versions 1 and 2 wrote it? */
export const isWhole = (record: ProjectRecord): boolean => !Array.isArray(record.pictures)

/** The keys of all pictures of a project. */
const picturesOf = (id: string) => IDBKeyRange.bound([id], [id, []])

/** Reads every record alone: as a project, or as one that is damaged. */
export function readRecords<Record extends { readonly id: string; readonly project: unknown }>(
  records: readonly Record[],
): { read: (Record & { readonly project: Project })[]; damaged: Damaged[] } {
  const read: (Record & { readonly project: Project })[] = []
  const damaged: Damaged[] = []
  for (const record of records)
    try {
      read.push({ ...record, project: parseProject(record.project) })
    } catch (cause) {
      if (!(cause instanceof ProjectError)) throw cause
      console.warn('A record cannot be read.', cause)
      damaged.push(damagedOf(record))
    }
  return { read, damaged }
}

const longestName = 200

function damagedOf(record: { readonly id: string; readonly project: unknown }): Damaged {
  const { id, project } = record
  const name = isObject(project) && typeof project['name'] === 'string' ? project['name'] : ''
  const { changed } = record as { changed?: unknown }
  return {
    id: String(id),
    name: name.slice(0, longestName) || null,
    changed: momentOf(changed),
    raw: project,
  }
}

/** The revision under which a project is saved now; null where there is none. */
export async function savedRevision(transaction: Reading | Writing, id: string): Promise<number | null> {
  const found = await transaction.objectStore('revisions').get(id)
  if (found) return revisionOf(found.revision)
  const record = await transaction.objectStore('projects').get(id)
  return record ? revisionOf(record.revision) : null
}

const announceAfter = (transaction: Writing, news: News) =>
  transaction.addEventListener('complete', () => announce(news))

/**
 * Writes a project in its parts. Pictures that are there already are not written again. Every write is announced once its
 * transaction has committed: other tabs follow it, and the outbox sends it to the class.
 * @param name where the write changes nothing but this
 */
export async function putProject(
  transaction: Writing,
  { id, project, changed, revision }: Kept,
  name?: string,
): Promise<void> {
  announceAfter(transaction, { kind: 'saved', id, revision, name })
  const store = transaction.objectStore('pictures')
  if (!isObject(project) || !isObject(project.assets)) {
    await transaction.objectStore('projects').put({ id, project, changed, revision })
    return
  }
  const { assets, ...document } = project
  const wanted = Object.keys(assets)
  const there = (await store.getAllKeys(picturesOf(id))).map(([, hash]) => hash)
  // Strings and plain objects only; a proxy or a function here would be a mistake of ours.
  const record = { id, project: { ...document, assets: {} }, changed, pictures: wanted }
  await transaction.objectStore('projects').put(record)
  await transaction.objectStore('revisions').put({ id, revision })
  for (const hash of wanted)
    if (!there.includes(hash)) await store.put({ project: id, hash, asset: assets[hash]! })
  for (const hash of there) if (!wanted.includes(hash)) await store.delete([id, hash])
}

/** A project with its pictures, whatever it is made of; null where there is none. */
export async function getProject(transaction: Reading | Writing, id: string): Promise<Kept | null> {
  const record = await transaction.objectStore('projects').get(id)
  if (!record) return null
  const revision = (await savedRevision(transaction, id)) ?? 1
  return { ...(await withPictures(transaction, record)), revision }
}

async function withPictures(
  transaction: Reading | Writing,
  record: ProjectRecord,
): Promise<Omit<Kept, 'revision'>> {
  const { id, project, changed } = record
  if (isWhole(record) || !isObject(project)) return { id, project, changed: momentOf(changed) }
  const pictures = await transaction.objectStore('pictures').getAll(picturesOf(id))
  const assets = Object.fromEntries(pictures.map(({ hash, asset }) => [hash, asset]))
  return { id, project: { ...project, assets }, changed: momentOf(changed) }
}

/** Deletes a project with everything that is its own, and announces it once the transaction has committed. */
export async function deleteProject(transaction: Writing, id: string): Promise<void> {
  announceAfter(transaction, { kind: 'gone', id })
  await transaction.objectStore('projects').delete(id)
  await transaction.objectStore('revisions').delete(id)
  await transaction.objectStore('pictures').delete(picturesOf(id))
}
