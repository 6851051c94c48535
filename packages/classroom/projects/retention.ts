const hour = 3_600_000
const day = 24 * hour
const newest = 20

export interface Dated {
  readonly revision: number
  /** Ms of the steady clock. */
  readonly savedAt: number
}

/**
 * Revisions that may go: all but the newest 20 and, for a day in which the server runs, the newest of each hour. Order is that of
 * the revisions.
 * @param now ms of the steady clock
 */
export function surplus(versions: readonly Dated[], now: number): readonly number[] {
  const ordered = versions.toSorted((one, other) => other.revision - one.revision)
  const hours = new Set<number>()
  return ordered
    .filter(({ savedAt }, at) => {
      const of = Math.floor(savedAt / hour)
      const first = !hours.has(of)
      hours.add(of)
      return at >= newest && !(first && now - savedAt < day)
    })
    .map(({ revision }) => revision)
}
