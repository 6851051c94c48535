import { clamp, type Point, type Size } from './points.ts'

/** One distance ray from the sensor to where it ends, with its length. Any unit. */
export interface Beam {
  readonly from: Point
  readonly to: Point
  readonly distance: number
}

/** Distance sensors reach this far (cm); further means that nothing was hit. */
const reach = { ultrasonic: 255, infrared: 70 }

/** What a distance sensor says of its nearest ray: ultrasonic cm, infrared 0 to 100. `hit`: is there anything as near as it reaches? */
export function readingOf(infrared: boolean, { distance }: Beam): { hit: boolean; reading: number } {
  const most = infrared ? reach.infrared : reach.ultrasonic
  return { hit: distance < most, reading: Math.round(infrared ? (distance / most) * 100 : distance) }
}

/** The cone as a polygon: the sensor, then the ends of its rays from one side to the other. */
export function conePolygon(beams: readonly Beam[]): readonly Point[] {
  const first = beams[0]
  if (!first) return []
  const middle = beams.reduce(
    (sum, { from, to }) => ({ x: sum.x + to.x - from.x, y: sum.y + to.y - from.y }),
    { x: 0, y: 0 },
  )
  const aside = ({ from, to }: Beam) => {
    const x = to.x - from.x
    const y = to.y - from.y
    return Math.atan2(middle.x * y - middle.y * x, middle.x * x + middle.y * y)
  }
  return [first.from, ...[...beams].sort((a, b) => aside(a) - aside(b)).map(({ to }) => to)]
}

/** The shortest ray; of equal ones the first (straight ahead). */
export const nearestBeam = (beams: readonly Beam[]): Beam | undefined =>
  beams.reduce<Beam | undefined>(
    (best, one) => (!best || one.distance < best.distance ? one : best),
    undefined,
  )

/** How far from the robot labels stand, and how much room each takes, in px. */
const label = { nearest: 44, farthest: 84, width: 54, height: 33 }

/**
 * Middles of the distance labels: on their lines, near the robot, clear of it and of each other. Px.
 * @param seen none of them is cut off by its edge
 */
export function labelPlaces(robot: Point, beams: readonly Beam[], seen: Size & Point): readonly Point[] {
  const inSight = ({ x, y }: Point): Point => ({
    x: clamp(x, seen.x + label.width / 2, seen.x + seen.width - label.width / 2),
    y: clamp(y, seen.y + label.height / 2, seen.y + seen.height - label.height / 2),
  })
  const places = beams.map(({ from, to }) => {
    const dx = to.x - from.x
    const dy = to.y - from.y
    const length = Math.hypot(dx, dy) || 1
    const out = clamp(length / 2, 0, label.farthest)
    return inSight(clearOf(robot, { x: from.x + (dx / length) * out, y: from.y + (dy / length) * out }))
  })
  for (let i = 0; i < places.length; i++)
    for (let j = i + 1; j < places.length; j++) {
      const [a, b] = apart(places[i]!, places[j]!)
      places[i] = a
      places[j] = b
    }
  return places.map(inSight)
}

function clearOf(robot: Point, place: Point): Point {
  const dx = place.x - robot.x
  const dy = place.y - robot.y
  const away = Math.hypot(dx, dy)
  if (away >= label.nearest) return place
  const stretch = away === 0 ? 0 : label.nearest / away
  return { x: robot.x + dx * stretch, y: robot.y + (away === 0 ? -label.nearest : dy * stretch) }
}

/** Pushes two labels apart by equal parts, without a jump as they near each other. */
function apart(a: Point, b: Point): readonly [Point, Point] {
  const dx = b.x - a.x || 0.01
  const dy = b.y - a.y
  const closeness = Math.hypot(dx / label.width, dy / label.height)
  if (closeness >= 1) return [a, b]
  const push = (1 / closeness - 1) / 2
  return [
    { x: a.x - dx * push, y: a.y - dy * push },
    { x: b.x + dx * push, y: b.y + dy * push },
  ]
}
