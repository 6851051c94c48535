import type { Cm, RobotConfig, Shape } from '../types.ts'

/** A convex piece of a body in the body's own frame: corners counter-clockwise, or a circle round the origin. */
export type Part =
  | { readonly kind: 'polygon'; readonly corners: readonly (readonly [x: Cm, y: Cm])[] }
  | { readonly kind: 'circle'; readonly radius: Cm }

/** The robot's box reaches this far from the middle of the axle. */
export const FRONT = 10
export const REAR = 6.7
export const HALF_WIDTH = 6.65
const WHEEL_WIDTH = 2.8

/** The robot's outline: its box, and a bar across the wheels. */
export function partsOfRobot({ wheelDiameter, trackWidth }: RobotConfig): readonly Part[] {
  const reach = wheelDiameter / 2
  const across = trackWidth / 2 + WHEEL_WIDTH / 2
  return [rectangle(-REAR, -HALF_WIDTH, FRONT, HALF_WIDTH), rectangle(-reach, -across, reach, across)]
}

/** The outline of an obstacle or area. A triangle stands on its width, with the tip at half its height in +y, `tip` to the right. */
export function partOfShape(shape: Shape): Part {
  if (shape.kind === 'circle') return shape
  const x = shape.width / 2
  const y = shape.height / 2
  if (shape.kind === 'rectangle') return rectangle(-x, -y, x, y)
  return { kind: 'polygon', corners: [[-x, -y], [x, -y], [shape.tip ?? 0, y]] } // prettier-ignore
}

function rectangle(left: Cm, bottom: Cm, right: Cm, top: Cm): Part {
  return { kind: 'polygon', corners: [[left, bottom], [right, bottom], [right, top], [left, top]] } // prettier-ignore
}
