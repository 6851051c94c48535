import { isPrivate } from './https/constraints.ts'

interface Announcing {
  /** How pages reach the server where a proxy stands before it, or where it has a name; else null. */
  readonly publicAddress: string | null
  readonly proxied: boolean
  /** Under which it is reached, this machine's own name first, https before http elsewhere. */
  readonly addresses: () => readonly string[]
}

const isOwn = (host: string) => host === 'localhost'

/**
 * The one address that a device is told, since browsers keep work by address. Of a machine in two networks each device is
 * told the one that it has reached: it may not get to the other.
 * @param reached this machine's address that was asked; null where that is not known
 */
export function announcedTo(
  reached: string | null,
  { publicAddress, proxied, addresses }: Announcing,
): string | null {
  if (publicAddress !== null) return publicAddress
  if (proxied) return null
  const others = addresses().filter((address) => !isOwn(new URL(address).hostname))
  const same = others.find((address) => new URL(address).hostname === reached)
  return same ?? others.find((address) => isPrivate(new URL(address).hostname)) ?? others[0] ?? null
}
