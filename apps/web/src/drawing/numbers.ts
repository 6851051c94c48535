import { writeNumber } from '@botgarten/messages'
import { clamp } from './points.ts'
import type { Scale } from './track.ts'

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
