import { existsSync, readFileSync } from 'node:fs'
import { fine, wrong } from './finding.ts'

/** What a device gives itself where no router has given it an address (RFC 3927). */
const isSelfMade = (address: string) => new URL(address).hostname.startsWith('169.254.')
const isLocal = (address: string) => new URL(address).hostname === 'localhost'

const listed = (addresses: readonly string[]) => addresses.join(', ')

/**
 * Can other devices find this one?
 * @param addresses where a server is reached now
 * @param before where it was reached at its last start; empty where that is not known
 */
export function examineAddress(addresses: readonly string[], before: readonly string[]) {
  const others = addresses.filter((address) => !isLocal(address))
  const given = others.filter((address) => !isSelfMade(address))
  if (others.length === 0) return wrong('address.none')
  if (given.length === 0) return wrong('address.selfMade', { addresses: listed(others) })
  const known = before.filter((address) => !isLocal(address))
  const facts = { addresses: listed(given), before: listed(known) }
  const isOther = known.length > 0 && !known.some((address) => given.includes(address))
  return isOther ? wrong('address.changed', facts) : fine('address.found', facts)
}

export interface Firewall {
  readonly platform: NodeJS.Platform
  readonly port: number
  /** Text of `/etc/ufw/ufw.conf`; null where there is none. */
  readonly ufw: string | null
  /** When another device has reached the server, ms since 1970; null: none has. */
  readonly reachedAt: number | null
}

const ufwFile = '/etc/ufw/ufw.conf'

/** @param reachedAt as in `Firewall` */
export const firewallHere = (port: number, reachedAt: number | null): Firewall => ({
  platform: process.platform,
  port,
  ufw: existsSync(ufwFile) ? readFileSync(ufwFile, 'utf8') : null,
  reachedAt,
})

/**
 * Does a firewall keep other devices out? No program sees that from the inside: what counts is that another device has
 * been there; else the rule is given that lets them in.
 */
export function examineFirewall({ platform, port, ufw, reachedAt }: Firewall) {
  if (reachedAt !== null)
    return fine('firewall.reached', { day: new Date(reachedAt).toISOString().slice(0, 10) })
  if (ufw !== null && /^ENABLED=yes$/m.test(ufw)) return wrong('firewall.ufw', { port })
  if (platform === 'win32') return fine('firewall.windows', { port })
  if (platform === 'darwin') return fine('firewall.mac', { port })
  return fine('firewall.unknown', { port })
}
