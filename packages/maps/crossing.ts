import { between, distance, type Point } from './point.ts'

/** cm. A follower that gets so near to another part of its line loses it: measured on 70 random roads. */
const NEAR = 4
/** cm along the line. Parts that are less far apart are one bend. */
const APART = 40
/** cm. So far a line is drawn beyond its end: to the bar that stops the robot. */
const BEYOND = 8.5

/** Does a line come back to itself, or to where its ends stop the robot? @param points in cm, not more than 2 cm from one to the next */
export function meetsItself(points: readonly Point[]): boolean {
  if (points.length < 3) return false
  const line = [beyond(points[1]!, points[0]!), ...points, beyond(points.at(-2)!, points.at(-1)!)]
  const along = walkedTo(line)
  return line.some((point, index) => {
    let next = along.findIndex((cm) => cm - along[index]! > APART)
    while (next >= 0 && next < line.length) {
      const gap = distance(point, line[next]!) - NEAR
      if (gap < 0) return true
      // Along the line nothing gets nearer faster than this.
      const from = along[next]! + gap
      while (next < line.length && along[next]! <= from) next++
    }
    return false
  })
}

const beyond = (before: Point, end: Point): Point => between(before, end, 1 + BEYOND / distance(before, end))

/** How far along a line each of its points lies, in cm. */
function walkedTo(line: readonly Point[]): readonly number[] {
  let walked = 0
  return line.map((point, index) => (walked += index === 0 ? 0 : distance(line[index - 1]!, point)))
}
