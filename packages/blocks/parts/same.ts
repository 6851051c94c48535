import type { Value } from '../types.ts'

/** Are two values equal? Lists entry by entry; colours in either case. */
export function same(a: Value | undefined, b: Value | undefined): boolean {
  if (isList(a) && isList(b)) return a.length === b.length && a.every((entry, k) => same(entry, b[k]))
  if (typeof a === 'string' && typeof b === 'string') return a === b || equalColours(a, b)
  return a === b
}

const isList = (value: Value | undefined): value is readonly Value[] => Array.isArray(value)

const equalColours = (a: string, b: string) =>
  a.length === 7 && a.startsWith('#') && b.startsWith('#') && a.toUpperCase() === b.toUpperCase()
