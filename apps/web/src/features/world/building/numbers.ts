/** A number as it was typed, with dot or comma, minus of either kind, in tenths; null for no number or one out of bounds. */
export function parseNumber(text: string, least: number, most: number): number | null {
  const plain = text.trim().replace(',', '.').replace('−', '-')
  if (!/^-?\d*\.?\d*$/.test(plain) || !/\d/.test(plain)) return null
  const number = Math.round(Number(plain) * 10) / 10
  return number >= least && number <= most ? number : null
}
