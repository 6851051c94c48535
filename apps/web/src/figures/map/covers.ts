import type { QLearner } from '@botgarten/learning/q-learning'
import { set } from './svg.ts'

/** A hedge may always be seen through a little, so that nobody loses the map. */
const THINNEST = 0.06

/**
 * Lets the cover of a road fade; `worth` 0..1. Forest and Mars: the cover itself. City: litter first, then the tone. A
 * cover is one path: fading its fill and its stroke is as good as fading it as a group, which would be a layer of its own
 * in every frame.
 */
export function fade(cover: Element, worth: number, isCity: boolean): void {
  const clean = isCity && worth >= 0.98
  const late = clean ? 0 : Math.max(THINNEST, isCity ? Math.min(1, 2 - worth * 2) : 1 - worth)
  set(cover, 'fill-opacity', late.toFixed(2))
  set(cover, 'stroke-opacity', (isCity ? Math.max(0, 1 - worth * 2) : late).toFixed(2))
}

/** How good each road is, 0..1 beside the best: of both directions the better one. By `a-b`, a < b. */
export function worthOf(
  { from, meant }: QLearner['world'],
  q: ArrayLike<number>,
): ReadonlyMap<string, number> {
  let highest = 0
  for (let move = 0; move < q.length; move++) highest = Math.max(highest, q[move]!)
  const worth = new Map<string, number>()
  for (let move = 0; highest > 0 && move < q.length; move++) {
    const [a, b] = [from[move]!, meant[move]!]
    const name = a < b ? `${a}-${b}` : `${b}-${a}`
    // A root: what is four sections from the goal shall be seen too.
    const share = Math.sqrt(Math.max(0, q[move]!) / highest)
    worth.set(name, Math.max(worth.get(name) ?? 0, share))
  }
  return worth
}
