/** In one frame: to make what answers to a hand takes a slow laptop a third of a millisecond each. */
const atATime = 6

/** The next of the lists on the way from what is there to what is wanted: a few more of these, a few less of those. */
export function nearer<T>(
  there: readonly T[],
  wanted: readonly T[],
  keyOf: (one: T) => number,
): readonly T[] {
  const next = new Map(wanted.map((one) => [keyOf(one), one]))
  const kept = new Set(there.map(keyOf))
  const gone = there.filter((one) => !next.has(keyOf(one)))
  const leaving = new Set(gone.slice(0, atATime).map(keyOf))
  const coming = new Set([...next.keys()].filter((key) => !kept.has(key)).slice(0, atATime))
  const all = wanted.filter((one) => kept.has(keyOf(one)) || coming.has(keyOf(one)))
  return [...all, ...gone.filter((one) => !leaving.has(keyOf(one)))]
}

/** The same list, of what is wanted still as it is wanted. */
export function renewed<T>(
  there: readonly T[],
  wanted: readonly T[],
  keyOf: (one: T) => number,
): readonly T[] {
  const next = new Map(wanted.map((one) => [keyOf(one), one]))
  const all = there.map((one) => next.get(keyOf(one)) ?? one)
  return all.every((one, i) => one === there[i]) ? there : all
}
