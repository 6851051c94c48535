import { fine, wrong } from './finding.ts'

/** A night may be left out by a weekend and a holiday; after so many days the copies are no longer made. */
const oldAfter = 5
const aDay = 86_400_000

export interface Saved {
  /** There is a database that could be copied. */
  readonly exists: boolean
  /** Days of the nightly copies by the clock of their time, in the order in which they were made: `2026-11-24`. */
  readonly nights: readonly string[]
}

/** Is there a backup, and is it of these days? @param now ms since 1970 */
export function examineBackup({ exists, nights }: Saved, now: number) {
  const day = nights.at(-1)
  if (day === undefined) return exists ? wrong('backup.none') : fine('backup.noData')
  const facts = { day, count: nights.length }
  const age = now - Date.parse(day)
  // The day begins up to 14 hours earlier east of Greenwich.
  if (age < -aDay) return wrong('backup.ahead', facts)
  return age > oldAfter * aDay ? wrong('backup.old', facts) : fine('backup.made', facts)
}
