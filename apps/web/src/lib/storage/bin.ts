import { announce } from './channel.ts'
import { database, troubleOf, type Kept, type Thrown, type Trouble } from './database.ts'
import { firstRevision, freshId } from './projects.ts'

const DAYS_KEPT = 30
const DAY = 86_400_000

/** Whole days until something in the bin is forgotten, 1 on its last one. */
export const daysLeft = (thrown: number, now: number): number =>
  Math.min(DAYS_KEPT, Math.max(1, Math.ceil((thrown + DAYS_KEPT * DAY - now) / DAY)))

/** How long something has lain in the bin: at most as long as it is kept there. */
export const ageInBin = (thrown: number, now: number): number =>
  Math.min(DAYS_KEPT * DAY, Math.max(0, now - thrown))

export const isOver = (thrown: number, now: number): boolean => now - thrown >= DAYS_KEPT * DAY

/** `gone`: another tab has moved it already. */
type Moved = { readonly kind: 'moved'; readonly id: string } | { readonly kind: 'gone' | Trouble }

const stores = ['projects', 'bin'] as const

/** Puts a project into the bin, as whoever saved last has left it. Both happen, or neither. */
export async function throwAway(id: string): Promise<Moved> {
  try {
    const transaction = (await database()).transaction(stores, 'readwrite', { durability: 'strict' })
    const found = await transaction.objectStore('projects').get(id)
    if (!found) return { kind: 'gone' }
    const thrown: Thrown = { ...found, id: freshId('bin'), was: id, thrown: Date.now() }
    await transaction.objectStore('bin').put(thrown)
    await transaction.objectStore('projects').delete(id)
    await transaction.done
    announce({ kind: 'gone', id })
    return { kind: 'moved', id: thrown.id }
  } catch (cause) {
    return { kind: troubleOf(cause) }
  }
}

/** Takes a project out of the bin. It gets its old key, or a new one where something else has that now. */
export async function takeBack(id: string): Promise<Moved> {
  try {
    const transaction = (await database()).transaction(stores, 'readwrite', { durability: 'strict' })
    const found = await transaction.objectStore('bin').get(id)
    if (!found) return { kind: 'gone' }
    const { was, thrown: _thrown, ...kept } = found
    const taken = await transaction.objectStore('projects').getKey(was)
    const back: Kept = {
      ...kept,
      id: taken === undefined ? was : freshId(was.replace(/-[^-]*$/, '')),
      revision: firstRevision(),
    }
    await transaction.objectStore('projects').put(back)
    await transaction.objectStore('bin').delete(id)
    await transaction.done
    announce({ kind: 'saved', id: back.id, revision: back.revision })
    return { kind: 'moved', id: back.id }
  } catch (cause) {
    return { kind: troubleOf(cause) }
  }
}

/** What lies in the bin, the last thrown first. What has lain there for 30 days is forgotten on the way. */
export async function listBin(): Promise<readonly Thrown[]> {
  try {
    const transaction = (await database()).transaction('bin', 'readwrite')
    const all = await transaction.store.getAll()
    const now = Date.now()
    const over = all.filter(({ thrown }) => isOver(thrown, now))
    await Promise.all(over.map(({ id }) => transaction.store.delete(id)))
    await transaction.done
    return all.filter((one) => !over.includes(one)).sort((a, b) => b.thrown - a.thrown)
  } catch (cause) {
    console.warn('The bin cannot be read on this device.', cause)
    return []
  }
}

/** Puts projects into the bin that come from elsewhere. All of them, or none. */
export async function addToBin(all: readonly Omit<Thrown, 'id' | 'revision'>[]): Promise<Trouble | null> {
  try {
    const transaction = (await database()).transaction('bin', 'readwrite', { durability: 'strict' })
    const revision = firstRevision()
    await Promise.all(all.map((one) => transaction.store.add({ ...one, id: freshId('bin'), revision })))
    await transaction.done
    return null
  } catch (cause) {
    return troubleOf(cause)
  }
}

/** Forgets these for good: what the child has seen in the bin, and nothing that another tab has put there since. */
export async function emptyBin(ids: readonly string[]): Promise<Trouble | null> {
  try {
    const transaction = (await database()).transaction('bin', 'readwrite', { durability: 'strict' })
    await Promise.all(ids.map((id) => transaction.store.delete(id)))
    await transaction.done
    return null
  } catch (cause) {
    return troubleOf(cause)
  }
}
