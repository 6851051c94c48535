/** A curve has so many points at most. */
const MOST = 100

/** Tries after which a race is looked at, counted from 1: each of up to a hundred, else the first and a hundred in equal steps. */
export function pointsOf(tries: number): readonly number[] {
  if (tries <= MOST) return Array.from({ length: tries }, (_, index) => index + 1)
  const even = Array.from({ length: MOST }, (_, index) => Math.round(((index + 1) * tries) / MOST))
  return [1, ...even]
}
