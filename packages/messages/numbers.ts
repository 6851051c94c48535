const formats = new Map<string, Intl.NumberFormat>()

/** Shown in place of a value that is no number. */
const NO_NUMBER = '–'

interface Written {
  /** Places behind the comma, at least and at most. */
  readonly least?: number
  readonly most?: number
  /** With marks between thousands? */
  readonly grouped?: boolean
  /** Above 0 with a plus. */
  readonly plus?: boolean
  /** A share of 1 as a percentage. */
  readonly percent?: boolean
}

/** Every number on a screen: with the language's own comma and a real minus; NaN and infinite values become a dash. */
export function writeNumber(
  value: number,
  locale: string,
  { least = 0, most = Math.max(3, least), grouped = true, plus, percent }: Written = {},
): string {
  if (!Number.isFinite(value)) return NO_NUMBER
  const key = [locale, least, most, grouped, plus, percent].join()
  const format =
    formats.get(key) ??
    new Intl.NumberFormat(locale, {
      ...{ minimumFractionDigits: least, maximumFractionDigits: most, useGrouping: grouped },
      style: percent ? 'percent' : 'decimal',
      signDisplay: plus ? 'exceptZero' : 'negative',
    })
  formats.set(key, format)
  return format.format(value).replace('-', '−')
}
