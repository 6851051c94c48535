const formats = new Map<string, Intl.NumberFormat>()

/** A number as a child reads it: at most `digits` behind the comma, no trailing zeros, the language's own comma. */
export function formatNumber(value: number, locale: string, digits = 2): string {
  const key = `${locale} ${digits}`
  let format = formats.get(key)
  if (!format) {
    format = new Intl.NumberFormat(locale, {
      maximumFractionDigits: digits,
      useGrouping: false,
      signDisplay: 'negative',
    })
    formats.set(key, format)
  }
  return format.format(value).replace('-', '−')
}

/** A weight as it was typed, with dot or comma, cut to 0..1 and rounded to hundredths; null where it is no number. */
export function parseWeight(text: string): number | null {
  const plain = text.trim().replace(',', '.')
  if (!/^\d*\.?\d*$/.test(plain) || !/\d/.test(plain)) return null
  return Math.min(1, Math.round(Number(plain) * 100) / 100)
}
