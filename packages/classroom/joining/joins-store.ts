import type { Db } from '../database/database.ts'
import { keyedHash } from '../hashes.ts'
import { Refusal } from '../refusal.ts'

const windowLength = 10 * 60_000
/** New pupils of one device within ten minutes: a class may share it, one after the other. */
const mostJoins = 10

interface Clocked {
  readonly db: Db
  /** Of the steady clock. */
  readonly now: number
  readonly secret: Uint8Array
}

const joinsOf = (device: string, secret: Uint8Array) => keyedHash(secret, 'joins', device)

/**
 * @param device its cookie; null for a device without one: its address may be shared by a whole school, and the class is bounded
 * @throws Refusal 429 for a device that has made too many pupils
 */
export async function refuseMoreJoins({ db, now, secret }: Clocked, device: string | null): Promise<void> {
  if (device === null) return
  const row = await db
    .selectFrom('attempt')
    .select(['count', 'endsAt'])
    .where('key', '=', joinsOf(device, secret))
    .where('endsAt', '>', now)
    .executeTakeFirst()
  if (row && row.count >= mostJoins)
    throw new Refusal(429, 'tooManyTries', { seconds: Math.ceil((row.endsAt - now) / 1000) })
}

/** Counts a pupil that a device has made. */
export async function countJoin({ db, now, secret }: Clocked, device: string): Promise<void> {
  await db.deleteFrom('attempt').where('endsAt', '<=', now).execute()
  await db
    .insertInto('attempt')
    .values({ key: joinsOf(device, secret), count: 1, endsAt: now + windowLength })
    .onConflict((conflict) =>
      conflict.column('key').doUpdateSet((row) => ({ count: row('attempt.count', '+', 1) })),
    )
    .execute()
}
