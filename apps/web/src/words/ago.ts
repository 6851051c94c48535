const units = [
  ['day', 86_400_000],
  ['hour', 3_600_000],
  ['minute', 60_000],
] as const

/** "2 minutes ago" in the child's language; "now" within the first minute. */
export function ago(when: number, now: number, locale: string): string {
  const words = new Intl.RelativeTimeFormat(locale, { numeric: 'auto' })
  const past = Math.max(0, now - when)
  for (const [unit, length] of units)
    if (past >= length) return words.format(-Math.floor(past / length), unit)
  return words.format(0, 'second')
}
