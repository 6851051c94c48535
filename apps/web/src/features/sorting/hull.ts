export interface Spot {
  readonly x: number
  readonly y: number
}

const turn = (a: Spot, b: Spot, c: Spot) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)

function half(spots: readonly Spot[]): Spot[] {
  const found: Spot[] = []
  for (const spot of spots) {
    while (found.length > 1 && turn(found.at(-2)!, found.at(-1)!, spot) <= 0) found.pop()
    found.push(spot)
  }
  return found.slice(0, -1)
}

/** The convex hull (Andrew's monotone chain), counter-clockwise; one or two spots are their own. */
export function hullOf(spots: readonly Spot[]): Spot[] {
  const sorted = spots.toSorted((a, b) => a.x - b.x || a.y - b.y)
  if (sorted.length < 3) return sorted
  return [...half(sorted), ...half(sorted.toReversed())]
}
