import { parseNumber } from '#drawing/numbers.ts'

/** A number as it was typed, rounded to tenths; null for no number or one out of bounds. */
export function parseTenths(text: string, least: number, most: number): number | null {
  const number = parseNumber(text)
  if (number === null) return null
  const tenths = Math.round(number * 10) / 10
  return tenths >= least && tenths <= most ? tenths : null
}
