import { tried, storageErrorIn, writing, type Thrown, type StorageError, type Writing } from './database.ts'
import { freshId } from './projects.ts'
import {
  deleteProject,
  firstRevision,
  getProject,
  momentOf,
  putProject,
  readRecords,
  savedRevision,
  type Damaged,
} from './records.ts'

/** So many days of use something lies in the bin. */
export const DAYS_KEPT = 30

/** Something in the bin, and how many days of use are left until it is forgotten: 1 on its last one. */
export interface Binned extends Pick<Thrown, 'id' | 'was' | 'project' | 'changed' | 'thrown'> {
  readonly left: number
}

/** What lies in the bin, the last thrown first, and what of it cannot be read. */
export interface Bin {
  readonly thrown: readonly Binned[]
  readonly damaged: readonly Damaged[]
}

/** Something that comes into the bin from elsewhere, where it was for so many days of use. */
export interface ToBin extends Omit<Binned, 'id' | 'left'> {
  readonly daysIn: number
}

/** `gone`: another tab has moved it already. */
type Moved = { readonly kind: 'moved'; readonly id: string } | { readonly kind: 'gone' | StorageError }

/** Puts a project into the bin, as whoever saved last has left it, damaged or not. Both happen, or neither. */
export async function throwAway(id: string): Promise<Moved> {
  return tried<Moved>(async (transaction) => {
    const found = await getProject(transaction, id)
    if (!found) return { kind: 'gone' }
    const now = Date.now()
    const day = await daysOfUse(transaction, now)
    const thrown: Thrown = { ...found, id: freshId('bin'), was: id, thrown: now, day }
    await transaction.objectStore('bin').put(thrown)
    await deleteProject(transaction, id)
    await noteThrown(transaction, id)
    return { kind: 'moved', id: thrown.id }
  })
}

/** What a class has, or is about to get, is thrown away there too. */
async function noteThrown(transaction: Writing, id: string): Promise<void> {
  const sync = await transaction.objectStore('sync').get(id)
  const isOnItsWay = (await transaction.objectStore('outbox').getKey(id)) !== undefined
  if (!sync && !isOnItsWay) return
  const { base = 0, synced = 0, hash, seen } = sync ?? {}
  await transaction.objectStore('sync').put({ id, base, hash, seen, synced, thrown: true })
}

/** Takes a project out of the bin. It gets its old key, or a new one where something else has that now. */
export async function takeBack(id: string): Promise<Moved> {
  const revision = firstRevision()
  return tried<Moved>(async (transaction) => {
    const found = await transaction.objectStore('bin').get(id)
    if (!found) return { kind: 'gone' }
    const was = typeof found.was === 'string' && found.was !== '' ? found.was : 'free'
    const free = (await savedRevision(transaction, was)) === null
    const back = free ? was : freshId(was.replace(/-[^-]*$/, ''))
    const { project, changed } = found
    await putProject(transaction, { id: back, project, changed: momentOf(changed), revision })
    await transaction.objectStore('bin').delete(id)
    return { kind: 'moved', id: back }
  })
}

/** What lies in the bin. What has lain there for 30 days of use is forgotten on the way. */
export async function listBin(): Promise<Bin> {
  try {
    const all = await writing(async (transaction) => {
      const today = await daysOfUse(transaction, Date.now())
      const kept: (Thrown & { readonly left: number })[] = []
      for (const record of await transaction.objectStore('bin').getAll()) {
        const left = DAYS_KEPT - (today - (await dayThrown(transaction, record, today)))
        if (left > 0) kept.push({ ...record, thrown: momentOf(record.thrown), left })
        else await transaction.objectStore('bin').delete(record.id)
      }
      return kept
    })
    const { read, damaged } = readRecords(all.sort((a, b) => b.thrown - a.thrown))
    return { thrown: read, damaged }
  } catch (cause) {
    console.warn('The bin cannot be read on this device.', cause)
    return { thrown: [], damaged: [] }
  }
}

/** The day of use on which something came into the bin: today, where that was not counted or cannot be. */
async function dayThrown(transaction: Writing, record: Thrown, today: number): Promise<number> {
  const { day } = record
  if (day !== undefined && Number.isSafeInteger(day) && day <= today) return day
  await transaction.objectStore('bin').put({ ...record, day: today })
  return today
}

/** Puts projects into the bin that come from elsewhere. All of them, or none. */
export async function addToBin(all: readonly ToBin[]): Promise<StorageError | null> {
  return storageErrorIn(async (transaction) => {
    const revision = firstRevision()
    const today = await daysOfUse(transaction, Date.now())
    for (const { daysIn, ...one } of all)
      await transaction.objectStore('bin').add({ ...one, id: freshId('bin'), revision, day: today - daysIn })
  })
}

/** Forgets these for good: what the child has seen in the bin, and nothing that another tab has put there since. */
export async function emptyBin(ids: readonly string[]): Promise<StorageError | null> {
  return storageErrorIn(async (transaction) => {
    await Promise.all(ids.map((id) => transaction.objectStore('bin').delete(id)))
  })
}

// The bin forgets by days of use, not by the clock: a clock that jumps ahead makes one day of it, not thirty.

const key = 'used'

const dayOf = (now: number) => new Date(now).toISOString().slice(0, 10)

/**
 * On how many days Botgarten was used on this device, today among them. A day counts when it is later than the last one
 * that was seen: a clock that goes back and forth counts no day twice.
 */
export async function daysOfUse(transaction: Writing, now: number): Promise<number> {
  const store = transaction.objectStore('days')
  const found = await store.get(key)
  const count = found && Number.isSafeInteger(found.count) && found.count > 0 ? found.count : 0
  const last = typeof found?.last === 'string' ? found.last : ''
  const today = dayOf(now)
  if (count > 0 && today === last) return count
  const next = count === 0 || today > last ? count + 1 : count
  await store.put({ id: key, count: next, last: today })
  return next
}
