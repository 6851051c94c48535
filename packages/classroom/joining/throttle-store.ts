import type { Db } from '../database/database.ts'
import { keyedHash } from '../hashes.ts'
import { Refusal } from '../refusal.ts'

const minutes = 60_000
/** Wrong tries are counted for so long from the first one on. */
const windowLength = 10 * minutes

/** How many wrong codes or pictures each may try within ten minutes. */
const most = { device: 20, address: 200, server: 1000 } as const
type Scope = keyof typeof most

export interface Triers {
  /** The device's cookie; null for one that sends none, which only its address holds. */
  readonly device: string | null
  readonly address: string
}

interface Clocked {
  readonly db: Db
  readonly now: number
  readonly secret: Uint8Array
}

/** The database keeps no address: only what it hashes to under a key that lies elsewhere. */
const keysOf = ({ device, address }: Triers, secret: Uint8Array): readonly (readonly [Scope, string])[] => [
  ...(device === null ? [] : [['device', keyedHash(secret, 'device', device)] as const]),
  ['address', keyedHash(secret, 'address', address)],
  ['server', 'server'],
]

/** @throws Refusal 429 where one of them has tried too often */
export async function refuseThrottled({ db, now, secret }: Clocked, triers: Triers): Promise<void> {
  const keys = keysOf(triers, secret)
  const rows = await db
    .selectFrom('attempt')
    .selectAll()
    .where(
      'key',
      'in',
      keys.map(([, key]) => key),
    )
    .where('endsAt', '>', now)
    .execute()
  for (const [scope, key] of keys) {
    const row = rows.find((one) => one.key === key)
    if (row && row.count >= most[scope])
      throw new Refusal(429, 'tooManyTries', { seconds: Math.ceil((row.endsAt - now) / 1000) })
  }
}

/** Counts one wrong try for all of them. */
export async function countWrong({ db, now, secret }: Clocked, triers: Triers): Promise<void> {
  await db.transaction().execute(async (inside) => {
    await inside.deleteFrom('attempt').where('endsAt', '<=', now).execute()
    for (const [, key] of keysOf(triers, secret)) await countOne(inside, key, now + windowLength)
  })
}

/** One more under a key. @returns how many there are now */
async function countOne(db: Db, key: string, endsAt: number): Promise<number> {
  const { count } = await db
    .insertInto('attempt')
    .values({ key, count: 1, endsAt })
    .onConflict((conflict) =>
      conflict.column('key').doUpdateSet((row) => ({ count: row('attempt.count', '+', 1) })),
    )
    .returning('count')
    .executeTakeFirstOrThrow()
  return count
}

/** New pupils of one device within ten minutes: a class may share it, one after the other. */
const mostJoins = 10

/**
 * The key of the new pupils of a device; null for a device without a cookie: it is known by its address only, which a whole
 * school may share, and the class itself is bounded.
 */
const joinsOf = ({ device }: Triers, secret: Uint8Array) =>
  device === null ? null : keyedHash(secret, 'joins', device)

/** @throws Refusal 429 for a device that has made too many pupils */
export async function refuseMoreJoins({ db, now, secret }: Clocked, triers: Triers): Promise<void> {
  const key = joinsOf(triers, secret)
  if (key === null) return
  const row = await db
    .selectFrom('attempt')
    .select(['count', 'endsAt'])
    .where('key', '=', key)
    .where('endsAt', '>', now)
    .executeTakeFirst()
  if (row && row.count >= mostJoins)
    throw new Refusal(429, 'tooManyTries', { seconds: Math.ceil((row.endsAt - now) / 1000) })
}

/** Counts a pupil that a device has made. */
export async function countJoin({ db, now, secret }: Clocked, triers: Triers): Promise<void> {
  const key = joinsOf(triers, secret)
  if (key === null) return
  await db.deleteFrom('attempt').where('endsAt', '<=', now).execute()
  await countOne(db, key, now + windowLength)
}

const nights = 18 * 60 * minutes
const wrongPicturesADevice = 15

/** Counts wrong pictures of a device over all nicknames; it is locked at fifteen. */
export async function countWrongPictures({ db, now, secret }: Clocked, device: string): Promise<void> {
  await countOne(db, keyedHash(secret, 'pictures', device), now + nights)
}

/** @throws Refusal 429 for a device that tried wrong pictures on several nicknames */
export async function refuseLockedDevice({ db, now, secret }: Clocked, device: string): Promise<void> {
  const row = await db
    .selectFrom('attempt')
    .select(['count', 'endsAt'])
    .where('key', '=', keyedHash(secret, 'pictures', device))
    .where('endsAt', '>', now)
    .executeTakeFirst()
  if (row && row.count >= wrongPicturesADevice) throw new Refusal(429, 'deviceLocked')
}
