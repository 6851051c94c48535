import { fine, wrong } from './finding.ts'

/** A night may be left out by a weekend and a holiday; after so many days the copies are no longer made. */
const oldAfter = 5
const aDay = 86_400_000

export interface Saved {
  /** There is a database that could be copied. */
  readonly exists: boolean
  /** Files of the nightly copies, the oldest first: `2026-11-24.db`. */
  readonly nights: readonly string[]
}

/** Is there a backup, and is it of these days? @param now ms since 1970 */
export function examineBackup({ exists, nights }: Saved, now: number) {
  const day = nights.at(-1)?.slice(0, -'.db'.length)
  if (day === undefined) return exists ? wrong('backup.none') : fine('backup.noData')
  const facts = { day, count: nights.length }
  return now - Date.parse(day) > oldAfter * aDay ? wrong('backup.old', facts) : fine('backup.made', facts)
}
