import { keyedHash, newToken } from '../hashes.ts'
import { cookieIn } from '../joining/cookies.ts'
import type { Ports } from '../ports.ts'

/** A name of the device, and a mark for each of the accounts that were last signed in to there: `name.mark.mark`. */
export const knownCookie = 'botgarten-known'

/** Accounts that a device is known to: a computer of the staff room has several. */
const mostAccounts = 3

/** Only this server can make it: 96 bits. */
const markOf = (secret: Uint8Array, device: string, account: string) =>
  keyedHash(secret, 'known device', device, account).slice(0, 24)

const partsIn = (headers: Headers): readonly string[] => cookieIn(headers, knownCookie)?.split('.') ?? []

/** The name of a device that has signed in to this account before; null for any other. */
export function deviceKnownTo(secret: Uint8Array, headers: Headers, account: string): string | null {
  const [device = '', ...marks] = partsIn(headers)
  return marks.slice(0, mostAccounts).includes(markOf(secret, device, account)) ? device : null
}

/** The value of the cookie after signing in to an account. */
export function knownAfter(
  { secret, random }: Pick<Ports, 'secret' | 'random'>,
  headers: Headers,
  account: string,
): string {
  const [device = newToken(random), ...marks] = partsIn(headers)
  const mark = markOf(secret, device, account)
  return [device, ...[mark, ...marks.filter((one) => one !== mark)].slice(0, mostAccounts)].join('.')
}

/** The value of the cookie once the account is deleted; `''` where the device is known to no other. */
export function knownWithout(secret: Uint8Array, headers: Headers, account: string): string {
  const [device = '', ...marks] = partsIn(headers)
  const others = marks.filter((mark) => mark !== markOf(secret, device, account))
  return others.length === 0 ? '' : [device, ...others].join('.')
}
