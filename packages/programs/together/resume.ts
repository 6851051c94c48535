import { apply } from './apply.ts'
import { diff } from './diff.ts'
import { beginning, copyOf, type State } from './state.ts'
import type { Author, Entry, Operation, Shared } from './types.ts'

/** What an end finds of a pair when its page is opened again. */
export interface Found {
  readonly author: Author
  /** What the two began with. */
  readonly shared: Shared
  /** The common order from its beginning. */
  readonly entries: readonly Entry[]
  /** What this end has made; some of it may be in the common order already. */
  readonly pending: readonly Entry[]
  /** So many entries of the common order were shown here, one after the other; the last ones will do. */
  readonly shown: readonly number[]
}

/** Where a page can have stood: so much of the common order, and own entries on it. */
interface Place {
  readonly shared: Shared
  readonly length: number
}

/** So many own entries the saved program can be behind what its page has noted. */
const behind = 20

/**
 * What this end has made, with what nobody has noted: a hand goes on before a page has heard of the class, and a page may
 * go before its last step was noted. The saved program says so beside the place of the common order that it stands on:
 * the one from which the fewest operations lead to it.
 * @param saved as the device had it when the page was opened @param now as it is there by now
 */
export function resumed(found: Found, saved: Shared, now: Shared): readonly Entry[] {
  const { author, entries, pending } = found
  const { shared, length } = nearest(found, saved)
  const own = [...entries.filter(({ by }) => by === author), ...pending]
  const last = own.reduce((most, { n }) => Math.max(most, n), 0)
  const missed = diff(shared, now).map((op, k) => ({ by: author, n: last + 1 + k, base: length, op }))
  return [...pending, ...missed]
}

function nearest(found: Found, saved: Shared): Place {
  let best: { readonly place: Place; readonly ops: readonly Operation[] } | null = null
  for (const place of placesOf(found)) {
    const ops = diff(place.shared, saved)
    if (!best || ops.length < best.ops.length) best = { place, ops }
    if (ops.length === 0) break
  }
  return best!.place
}

/** The latest first. */
function placesOf({ author, shared, entries, pending, shown }: Found): readonly Place[] {
  const state = beginning(shared)
  const last = Math.min(Math.max(0, ...shown), entries.length)
  const places: Place[] = []
  for (let at = 0; at <= last; at++) {
    if (at === last || shown.includes(at)) {
      const known = new Set(entries.slice(0, at).flatMap(({ by, n }) => (by === author ? [n] : [])))
      const later = [...entries.slice(at), ...pending].filter(({ by, n }) => by === author && !known.has(n))
      places.push(...withOwn(state, once(later), at))
    }
    if (at < last) apply(state, entries[at]!, at)
  }
  return places.reverse()
}

const once = (own: readonly Entry[]) => [...new Map(own.map((entry) => [entry.n, entry])).values()]

function withOwn(state: State, own: readonly Entry[], length: number): readonly Place[] {
  const view = copyOf(state)
  const places: Place[] = [{ shared: view.doc, length }]
  for (const entry of own) {
    apply(view, entry, Number.MAX_SAFE_INTEGER)
    places.push({ shared: view.doc, length })
  }
  return places.slice(-behind)
}
