import { createHmac, hash, timingSafeEqual } from 'node:crypto'

/** Hash of a secret that is random enough by itself, such as a session's token. */
export const hashOf = (text: string): string => hash('sha256', text)

/** Keyed hash of what could be guessed: pictures, addresses. Useless to who has the database alone. */
export const keyedHash = (secret: Uint8Array, ...parts: readonly string[]): string =>
  createHmac('sha256', secret).update(JSON.stringify(parts)).digest('hex')

/** Are two hashes equal? Takes the same time wherever they differ. */
export const sameHash = (one: string, other: string): boolean =>
  one.length === other.length && timingSafeEqual(Buffer.from(one), Buffer.from(other))

/** A new id or token: 128 bits. */
export const newToken = (random: (bytes: number) => Uint8Array): string =>
  Buffer.from(random(16)).toString('base64url')
