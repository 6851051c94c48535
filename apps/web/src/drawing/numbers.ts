import { clamp } from './points.ts'
import type { Scale } from './track.ts'

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
}

/** Every number on a screen: with the language's own comma and a real minus; NaN and infinite values become a dash. */
export function writeNumber(
  value: number,
  locale: string,
  { least = 0, most = Math.max(3, least), grouped = true, plus = false }: Written = {},
): string {
  if (!Number.isFinite(value)) return NO_NUMBER
  const key = `${locale} ${least} ${most} ${grouped} ${plus}`
  let format = formats.get(key)
  if (!format) {
    format = new Intl.NumberFormat(locale, {
      ...{ minimumFractionDigits: least, maximumFractionDigits: most, useGrouping: grouped },
      signDisplay: plus ? 'exceptZero' : 'negative',
    })
    formats.set(key, format)
  }
  return format.format(value).replace('-', '−')
}

/** A number as a child reads it: at most `digits` behind the comma, no trailing zeros, the language's own comma. */
export const formatNumber = (value: number, locale: string, digits = 2): string =>
  writeNumber(value, locale, { most: digits, grouped: false })

/** What stands before the tenths in a language: a comma in German, a dot in English. */
export const decimalMark = (locale: string): string => formatNumber(0.5, locale).at(1)!

/** A number as it was typed, with dot or comma and either minus; null where it is none. */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace(',', '.').replace('−', '-')
  return /^-?\d*\.?\d*$/.test(plain) && /\d/.test(plain) ? Number(plain) : null
}

/** A weight as it was typed, cut to its scale and rounded to hundredths; null where it is no number of this scale. */
export function parseWeight(text: string, { least, most, unit }: Scale): number | null {
  const number = parseNumber(text)
  if (number === null || (least === 0 && /[-−]/.test(text))) return null
  return clamp(Math.round((number / unit) * 100) / 100, least, most)
}
