/** Where a page is. */
export type Place = Pick<Location, 'hostname' | 'origin'>

/** Only the machine of the server reaches it under these names. */
export const isOwnMachine = (hostname: string): boolean =>
  /^(localhost|127(\.\d+){3}|\[::1\])$/.test(hostname)

/** The address that other devices type: the one that the server announces, or where the page is. */
export const addressFor = (at: Pick<Place, 'origin'>, announced: string | null): string =>
  announced ?? at.origin
