// Compares this device's projects with the versions of the class, which may have been restored to an earlier state: from a
// backup, from a copied data folder, or by a database that failed over to a late replica.
import { reading, writing, type ClassVersion, type SyncRecord, type Writing } from './database.ts'
import { savedRevision } from './records.ts'

/** So many versions that a project was made from are remembered. */
const mostSeen = 60

export const unknown = (id: string): SyncRecord => ({ id, base: 0, synced: 0 })

const isSame = (
  one: Pick<ClassVersion, 'revision'> & { readonly hash?: string | undefined },
  other: ClassVersion,
) => one.revision === other.revision && one.hash === other.hash

/** The record of a project that is based on this version of the class now. @param synced its revision on the device; 0: an earlier one */
export function basedOn({ id, seen = [] }: SyncRecord, at: ClassVersion, synced: number): SyncRecord {
  const { revision, hash } = at
  const before = seen.filter((one) => !isSame(one, at))
  return { id, base: revision, hash, seen: [...before, { revision, hash }].slice(-mostSeen), synced }
}

/** Whether this device's work was made from the version of the class, though it is based on a later one. Then it replaces it. */
export const isBehind = ({ seen = [] }: SyncRecord, has: ClassVersion): boolean =>
  seen.some((one) => isSame(one, has))

/** The number of a mark among those of its pupil. */
const numberOf = (mark: string) => Number(mark.split('.')[0])

/**
 * Remembers a mark of the class, unless a newer one is known.
 * @param isRestored the class does not know the newer one
 */
export async function noteMark(transaction: Writing, mark: string | null, isRestored = false): Promise<void> {
  const store = transaction.objectStore('mark')
  if (mark === null) return isRestored ? store.clear() : undefined
  const known = (await store.get('mark'))?.mark
  if (isRestored || known === undefined || numberOf(known) < numberOf(mark))
    await store.put({ id: 'mark', mark })
}

/** The newest mark of the class that this device saw; null if it saw none. */
export const seenMark = (): Promise<string | null> =>
  reading(async (transaction) => (await transaction.objectStore('mark').get('mark'))?.mark ?? null)

/** The projects of a pupil in the class. */
export interface InClass {
  readonly projects: readonly (ClassVersion & { readonly id: string })[]
  /** Deleted projects, with their last revision. */
  readonly bin: readonly { readonly id: string; readonly revision: number }[]
  readonly mark: string | null
  /** Whether the class knows the mark that this device saw last. */
  readonly known: boolean
}

type Outcome = SyncRecord | 'drop' | 'leave' | 'unsure'

/** The new record of a project that is no longer on this device. */
function ofGone(sync: SyncRecord, has: ClassVersion | undefined, known: boolean): Outcome {
  if (!sync.gone || !has) return 'leave'
  const { revision, hash } = sync.gone
  // The class has lost the deletion.
  if (!known && isSame(sync.gone, has)) return { id: sync.id, base: revision, hash, synced: 0, thrown: true }
  return 'drop'
}

/** The new record of a project on this device. `unsure`: it depends on the versions that the class has. */
function ofOwn(
  sync: SyncRecord,
  has: ClassVersion | undefined,
  thrownAt: number | undefined,
  known: boolean,
): Outcome {
  const { id, base, hash, seen } = sync
  // Without the other version there is nothing to choose: this one is new to the class.
  if (sync.conflict !== undefined) return has ? 'leave' : { ...unknown(id), seen }
  if (base === 0) return 'leave'
  // Lost there: it is sent again as a new one.
  if (!has) return thrownAt !== undefined && thrownAt >= base ? 'leave' : { ...unknown(id), seen }
  if (has.revision === base) {
    if (hash === undefined) return { ...basedOn(sync, has, sync.synced) }
    return hash === has.hash ? 'leave' : { ...sync, conflict: base }
  }
  if (isBehind(sync, has)) return basedOn(sync, has, 0)
  if (has.revision < base) return { ...sync, conflict: has.revision }
  return known || hash === undefined ? 'leave' : 'unsure'
}

/**
 * Compares this device with the class. Work that the class has lost is sent again; if the class has other work after a
 * restore, the child chooses.
 * @returns ids of projects that need to be compared with the versions that the class has
 */
export async function compareWithClass(list: InClass): Promise<readonly string[]> {
  const has = new Map(list.projects.map((one) => [one.id, one]))
  const thrownAt = new Map(list.bin.map(({ id, revision }) => [id, revision]))
  return writing(async (transaction) => {
    const unsure: string[] = []
    for (const sync of await transaction.objectStore('sync').getAll()) {
      const { id } = sync
      // The answer to the save that is being sent decides.
      if ((await transaction.objectStore('outbox').getKey(id)) !== undefined) continue
      const isHere = (await savedRevision(transaction, id)) !== null
      const outcome = isHere
        ? ofOwn(sync, has.get(id), thrownAt.get(id), list.known)
        : ofGone(sync, has.get(id), list.known)
      if (outcome === 'unsure') unsure.push(id)
      else if (outcome === 'drop') await transaction.objectStore('sync').delete(id)
      else if (outcome !== 'leave') await transaction.objectStore('sync').put(outcome)
    }
    return unsure
  })
}

/** Notes whether a newer version of a restored class was made from the work here. @param versions of the class, any order */
export async function compareWithVersions(id: string, versions: readonly ClassVersion[]): Promise<void> {
  await writing(async (transaction) => {
    const sync = await transaction.objectStore('sync').get(id)
    if (!sync?.base || sync.conflict !== undefined) return
    if (versions.some((one) => isSame({ revision: sync.base, hash: sync.hash }, one))) return
    const newest = Math.max(...versions.map(({ revision }) => revision))
    await transaction.objectStore('sync').put({ ...sync, conflict: newest })
  })
}

/** Remembers the mark of a list that the device was compared with. */
export const noteCompared = ({ mark, known }: InClass): Promise<void> =>
  writing((transaction) => noteMark(transaction, mark, !known))
