import type { Point } from '#drawing/points.ts'
import type { Track } from '#drawing/track.ts'
import { level } from '#figures/network/level.svelte.ts'

/** px from the knob's middle to where its arrow begins, how long it is, and how far below its number stands. */
const lengths = { start: 17, line: 20, head: 9, aside: 25 }

/** An arrow from a knob along its link, forwards where the weight grows, and the place of its number. */
export function arrowAt({ from, to }: Track, at: Point, step: number) {
  const length = Math.hypot(to.x - from.x, to.y - from.y) || 1
  const way = { x: (to.x - from.x) / length, y: (to.y - from.y) / length }
  const sign = step < 0 ? -1 : 1
  const along = (px: number): Point => ({ x: at.x + sign * px * way.x, y: at.y + sign * px * way.y })
  const [a, b] = [along(lengths.start), along(lengths.start + lengths.line)]
  const tip = along(lengths.start + lengths.line + lengths.head)
  const wide = { x: -way.y * 6, y: way.x * 6 }
  return {
    path: `M${a.x} ${a.y}L${b.x} ${b.y}`,
    head: `M${tip.x} ${tip.y}L${b.x + wide.x} ${b.y + wide.y}L${b.x - wide.x} ${b.y - wide.y}Z`,
    label: { x: Math.round(at.x + 8), y: Math.round(at.y + lengths.aside) },
  }
}

/** Digits of a step behind the comma: one less for beginners. */
export const stepDigits = (): number => (level.deep ? 4 : 3)
