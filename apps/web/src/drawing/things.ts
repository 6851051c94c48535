import type { Point } from './points.ts'

/** The simulation's shapes, in cm. */
export type Outline =
  | { readonly kind: 'rectangle' | 'triangle'; readonly width: number; readonly height: number }
  | { readonly kind: 'circle'; readonly radius: number }

/** Radius of the circle around the middle that holds the whole thing. */
export const radiusOf = (shape: Outline): number =>
  shape.kind === 'circle' ? shape.radius : Math.hypot(shape.width, shape.height) / 2

/** Corners of a triangle about its middle, y down: the tip at the top, `tip` to the right of the middle. */
export const triangleCorners = (width: number, height: number, tip = 0): readonly Point[] => [
  { x: tip, y: -height / 2 },
  { x: width / 2, y: height / 2 },
  { x: -width / 2, y: height / 2 },
]

/** Joints of a brick wall about its middle, as a path. Courses run along the longer side. */
export function brickJoints(width: number, height: number, course = 6, brick = 12.5): string {
  if (height > width) return joints(height, width, course, brick, true)
  return joints(width, height, course, brick, false)
}

function joints(length: number, depth: number, course: number, brick: number, upright: boolean): string {
  const rows = Math.max(1, Math.round(depth / course))
  const columns = Math.max(1, Math.round(length / brick))
  const at = (along: number, across: number) => {
    const [x, y] = upright
      ? [across - depth / 2, along - length / 2]
      : [along - length / 2, across - depth / 2]
    return `${round(x)} ${round(y)}`
  }
  const step = { across: depth / rows, along: length / columns }
  const parts: string[] = []
  for (let row = 0; row < rows; row++) {
    const top = row * step.across
    if (row > 0) parts.push(`M${at(0, top)}L${at(length, top)}`)
    for (let x = (row % 2 ? 0.5 : 1) * step.along; x < length - 0.01; x += step.along)
      parts.push(`M${at(x, top)}L${at(x, top + step.across)}`)
  }
  return parts.join('')
}

const round = (value: number) => Math.round(value * 100) / 100

/** A heading as SVG and CSS turn: clockwise. */
export const clockwise = (heading: number): number => -heading

/** Degrees 0 ≤ … < 360. */
export const fullTurn = (degrees: number): number => ((degrees % 360) + 360) % 360

/** Heading in degrees (0 = east, counter-clockwise) from one point on the floor to another, y up. */
export const headingTo = (from: Point, to: Point): number =>
  fullTurn((Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI)

/** The point `distance` away in the direction `heading`, y up. */
export function ahead(from: Point, heading: number, distance: number): Point {
  const turn = (heading * Math.PI) / 180
  return { x: from.x + Math.cos(turn) * distance, y: from.y + Math.sin(turn) * distance }
}
