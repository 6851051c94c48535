/** Where a page is. */
export type Place = Pick<Location, 'hostname' | 'origin'>

/** Only the machine of the server reaches it under these names. */
export const isOwnMachine = (hostname: string): boolean =>
  /^(localhost|127(\.\d+){3}|\[::1\])$/.test(hostname)

/** The address that other devices type: where the page is, or one that the server names. */
export function addressFor(at: Place, addresses: readonly string[]): string {
  if (!isOwnMachine(at.hostname)) return at.origin
  return addresses.find((address) => !isOwnMachine(new URL(address).hostname)) ?? at.origin
}
