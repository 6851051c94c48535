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

/** What whoever runs the lab writes may change while the version stays. */
const changing = ['operator.md']

/** Decides about a request. Pages are found with and without a slash at their end, whatever stands behind the `?`. */
export function wayOf({ url, method, mode }: Asked, { scope, pages, files }: Own): Way {
  const address = url.replace(/[?#].*$/, '')
  if (method !== 'GET' || !url.startsWith(scope)) return { kind: 'server' }
  if (changing.some((name) => address === `${scope}${name}`)) return { kind: 'newest' }
  if (files.has(address)) return { kind: 'kept', address }
  if (mode !== 'navigate') return { kind: 'server' }
  const page = [address, address.replace(/\/$/, ''), `${address}/`].find((one) => pages.has(one))
  if (!page) return { kind: 'home' }
  return page === address
    ? { kind: 'kept', address }
    : { kind: 'moved', address: page + (/\?[^#]*/.exec(url)?.[0] ?? '') }
}
