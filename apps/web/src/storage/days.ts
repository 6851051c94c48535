import type { Writing } from './database.ts'

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
