/** Where an answer comes from. `server`: the browser asks it as if nobody stood between. */
export type Way =
  | { readonly kind: 'kept'; readonly address: string }
  /** To the address under which it is kept: what a page names stands beside that. */
  | { readonly kind: 'moved'; readonly address: string }
  /** From the server, and what was kept last where there is none. */
  | { readonly kind: 'newest' }
  /** From the server, and to the home page where there is none. */
  | { readonly kind: 'home' }
  | { readonly kind: 'server' }

interface Asked {
  readonly url: string
  readonly method: string
  readonly mode: string
}

/** What this version keeps: whole addresses without a query. `scope` ends with a slash. */
interface Own {
  readonly scope: string
  readonly pages: ReadonlySet<string>
  readonly files: ReadonlySet<string>
}

/** Folders whose pages are all the same file (offline.spec.ts and materials.spec.ts compare them). */
const shells = ['lab/', 'materials/']

/** Of pages that are the same file, as the lab's for every card, one is kept for all of them. */
export function oneOf(page: string, { scope, pages }: Pick<Own, 'scope' | 'pages'>): string {
  const isIn = (shell: string) => (address: string) =>
    address.startsWith(scope + shell) && address !== scope + shell
  const shell = shells.find((one) => isIn(one)(page))
  return shell ? [...pages].find(isIn(shell))! : page
}

/** What whoever runs the lab writes may change while the version stays. */
const changing = ['operator.md']

/** Decides about a request. Pages are found with and without a slash at their end, whatever stands behind the `?`. */
export function wayOf({ url, method, mode }: Asked, own: Own): Way {
  const { scope, pages, files } = own
  const address = url.replace(/[?#].*$/, '')
  if (method !== 'GET' || !url.startsWith(scope)) return { kind: 'server' }
  if (changing.some((name) => address === `${scope}${name}`)) return { kind: 'newest' }
  if (files.has(address)) return { kind: 'kept', address }
  if (mode !== 'navigate') return { kind: 'server' }
  const page = [address, address.replace(/\/$/, ''), `${address}/`].find((one) => pages.has(one))
  if (!page) return { kind: 'home' }
  return page === address
    ? { kind: 'kept', address: oneOf(page, own) }
    : { kind: 'moved', address: page + (/\?[^#]*/.exec(url)?.[0] ?? '') }
}

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
