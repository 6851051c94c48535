import type { Pose } from '@botgarten/simulation'
import type { Point } from '#drawing/points.ts'

/** Radians that the slower wheel's side turns by in an arrow, full speed against full speed. */
const TWIST = 1.9
const STEPS = 6
/** Below this speed in percent Bo stands. */
const STILL = 0.5

/**
 * The way a robot's nose would go, as a line in cm: from its middle on, so long that full speed goes from one arrow nearly to
 * the next. Empty where it stands.
 * @param left, right speed of the wheels in percent
 * @param spacing cm between two arrows
 */
export function arrowOf(pose: Pose, left: number, right: number, spacing: number): readonly Point[] {
  const [l, r] = [left, right].map((speed) => Math.max(-100, Math.min(100, speed)) / 100) as [number, number]
  if (Math.max(Math.abs(l), Math.abs(r)) * 100 < STILL) return []
  const ahead = ((l + r) / 2) * spacing * 0.55
  const turn = ((r - l) / 2) * TWIST
  const nose = spacing * 0.3 * (ahead < 0 ? -1 : 1)
  let heading = (pose.heading * Math.PI) / 180
  let { x, y } = pose
  const points: Point[] = [{ x, y }]
  for (let step = 0; step <= STEPS; step++) {
    if (step > 0) {
      const middle = heading + turn / STEPS / 2
      x += (Math.cos(middle) * ahead) / STEPS
      y += (Math.sin(middle) * ahead) / STEPS
      heading += turn / STEPS
    }
    points.push({ x: x + Math.cos(heading) * nose, y: y + Math.sin(heading) * nose })
  }
  return points
}

/** The two ends of an arrow's head at the end of its line, `size` long. */
export function headOf(points: readonly Point[], size: number): readonly [Point, Point] {
  const tip = points.at(-1)!
  const before = points.at(-2)!
  const angle = Math.atan2(tip.y - before.y, tip.x - before.x)
  const end = (by: number) => ({
    x: tip.x - size * Math.cos(angle + by),
    y: tip.y - size * Math.sin(angle + by),
  })
  return [end(0.55), end(-0.55)]
}
