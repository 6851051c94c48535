import { clamp } from './points.ts'
import type { Scale } from './track.ts'

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
