import { distance, distanceToSegment, type Point } from '#drawing/points.ts'

/** A hand that draws wobbles by so much (cm): the line is smoother than the hand. */
const wobble = 0.7

/** The fewest of these points whose line is nowhere farther than the wobble from what was drawn, at most `most`. */
export function smoothed(points: readonly Point[], most: number): readonly Point[] {
  const kept = new Set([0, points.length - 1])
  const spans: [number, number][] = [[0, points.length - 1]]
  for (let span = spans.pop(); span; span = spans.pop()) {
    const [from, to] = span
    const far = farthest(points, from, to)
    if (far === null) continue
    kept.add(far)
    spans.push([from, far], [far, to])
  }
  return [...kept].sort((a, b) => a - b).flatMap((index) => points[index] ?? []).slice(0, most) // prettier-ignore
}

function farthest(points: readonly Point[], from: number, to: number): number | null {
  let best: number | null = null
  let most = wobble
  for (let index = from + 1; index < to; index++) {
    const away = distanceToSegment(points[from]!, points[to]!, points[index]!)
    if (away <= most) continue
    most = away
    best = index
  }
  return best
}

/** With another point at the end, unless the pen has hardly moved. */
export function drawnTo(points: readonly Point[], at: Point, step = 1): readonly Point[] {
  const last = points.at(-1)
  return last && distance(last, at) < step ? points : [...points, at]
}
