const prefix = 'botgarten-'

/** Name of the cache of a version. Versions are moments, so that their names have an order. */
export const storeOf = (version: string): string => `${prefix}${version}`

/**
 * May this cache go, now that `version` has taken over? The one before stays as long as it is the last: a page of it may
 * still be open somewhere, and ask for a part.
 */
export function isPast(name: string, all: readonly string[], version: string): boolean {
  const others = all.filter((one) => one.startsWith(prefix) && one !== storeOf(version)).sort()
  return others.includes(name) && name !== others.at(-1)
}
