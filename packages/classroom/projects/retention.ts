const hour = 3_600_000
const day = 24 * hour
const newest = 20

export interface Dated {
  readonly revision: number
  readonly savedAt: number
}

/**
 * Revisions that may go: all but the newest 20 and, for a day, the newest of each hour. Order is that of the revisions,
 * not of the clock, which may have been set back.
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
