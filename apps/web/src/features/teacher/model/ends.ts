// Days are ISO texts, such as 2027-01-31: they compare as they are.

/** The day where the page stands, as an ISO text. */
export const isoDay = (date: Date): string =>
  [date.getFullYear(), date.getMonth() + 1, date.getDate()]
    .map((part) => String(part).padStart(2, '0'))
    .join('-')

/** The next end of a half of the school year, at least four weeks away: 31 January or 31 July. */
export function endOfHalfYear(today: Date): string {
  const soonest = isoDay(new Date(today.getFullYear(), today.getMonth(), today.getDate() + 28))
  const year = today.getFullYear()
  const ends = [`${year}-01-31`, `${year}-07-31`, `${year + 1}-01-31`]
  return ends.find((end) => end > soonest)!
}

/** So many days before or after a day. */
export function dayFrom(day: string, offset: number): string {
  const [year, month, date] = day.split('-').map(Number)
  return isoDay(new Date(year!, month! - 1, date! + offset))
}

/** A day as it is shown: "31 January 2027". */
export function dayLabel(day: string, locale: string): string {
  const [year, month, date] = day.split('-').map(Number)
  return new Date(year!, month! - 1, date).toLocaleDateString(locale === 'en' ? 'en-GB' : locale, {
    day: 'numeric',
    month: 'long',
    year: 'numeric',
  })
}
