import type { Frame, Next } from '../types.ts'
import { fail, give } from './next.ts'

/** The k-th value of a frame as a number; 0 where it is none (the check says so before). */
export function numberAt(frame: Frame, k: number): number {
  const value = frame.got[k]
  return typeof value === 'number' ? value : 0
}

export const cut = (x: number, least: number, most: number): number =>
  x <= least ? least : x > most ? most : x

/** Motors take −100..100 percent. Never −0. */
export const percent = (x: number): number => cut(x, -100, 100) + 0

/** A number as a file writes it (decimal point); null where the text is none, or one without end. */
export function numberIn(text: string): number | null {
  const x = text.trim() === '' ? NaN : Number(text)
  return Number.isFinite(x) ? x + 0 : null
}

/**
 * A result that was worked out. Without end only where a value that went in was (the constant does that); what is no
 * number at all, or has outgrown the greatest, fails.
 */
export function finite(x: number, frame: Frame): Next {
  if (Number.isFinite(x)) return give(x + 0)
  if (Number.isNaN(x)) return fail('noNumber')
  return frame.got.some((value) => value === Infinity || value === -Infinity) ? give(x) : fail('tooBigNumber')
}
