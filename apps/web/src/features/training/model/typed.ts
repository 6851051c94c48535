import { parseNumber } from '#drawing/numbers.ts'

interface Bounds {
  readonly least: number
  readonly most: number
  /** Only whole numbers. */
  readonly whole?: boolean
}

/** A number as it was typed, put into its bounds; what is no number gives the one before. */
export function typedNumber(text: string, { least, most, whole = false }: Bounds, before: number): number {
  const number = parseNumber(text) ?? exponentIn(text)
  if (number === null) return before
  const near = whole ? Math.round(number) : number
  return Math.max(least, Math.min(most, near))
}

/** "1e-3". */
function exponentIn(text: string): number | null {
  const number = /^[+-]?\d+(\.\d+)?e[+-]?\d+$/i.test(text.trim()) ? Number(text) : null
  return number !== null && Number.isFinite(number) ? number : null
}

/** How big a step may be, and how many rounds. */
export const rateBounds = { least: 0.0001, most: 5 } as const
export const roundsBounds = { least: 1, most: 100_000, whole: true } as const
