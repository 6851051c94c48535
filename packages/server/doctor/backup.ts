import { fine, wrong } from './finding.ts'

/** A night may be left out by a weekend and a holiday; after so many days the copies are no longer made. */
const oldAfter = 5
const aDay = 86_400_000

export interface Saved {
  /** There is a database that could be copied. */
  readonly exists: boolean
  /** Days of the nightly copies by the clock of their time, in the order in which they were made: `2026-11-24`. */
  readonly nights: readonly string[]
  /** Names of copies that are no nightly ones. */
  readonly others?: { readonly byAge: readonly string[]; readonly broken: readonly string[] }
}

/** Names without those of journals. */
const namesOf = (names: readonly string[]) => names.filter((name) => !/-(?:wal|shm)$/.test(name)).join(', ')

/** Is there a backup, and is it of these days? @param now ms since 1970 */
export function examineBackup({ exists, nights, others }: Saved, now: number) {
  const day = nights.at(-1)
  if (day === undefined) return exists ? wrong('backup.none') : fine('backup.noData')
  const facts = { day, count: nights.length }
  const age = now - Date.parse(day)
  // The day begins up to 14 hours earlier east of Greenwich.
  if (age < -aDay) return wrong('backup.ahead', facts)
  if (age > oldAfter * aDay) return wrong('backup.old', facts)
  const [broken, byAge] = [namesOf(others?.broken ?? []), namesOf(others?.byAge ?? [])]
  if (broken !== '') return fine('backup.withBroken', { ...facts, names: broken })
  return byAge === '' ? fine('backup.made', facts) : fine('backup.withCopies', { ...facts, names: byAge })
}
