const formats = new Map<string, Intl.NumberFormat>()

/** Ticks as seconds with exactly so many digits behind the comma: a number that runs keeps its width. */
export function inSeconds(ticks: number, locale: string, digits: number): string {
  const key = `${locale} ${digits}`
  const [minimumFractionDigits, maximumFractionDigits] = [digits, digits]
  const format =
    formats.get(key) ?? new Intl.NumberFormat(locale, { minimumFractionDigits, maximumFractionDigits })
  formats.set(key, format)
  return format.format(ticks / 60)
}
