import type { Point, Size } from './points.ts'

/** On which side of its knob a weight is written. */
export type Side = 'above' | 'below' | 'right' | 'left'

/** From a knob's middle to the middle of its written weight, in px; earlier sides are taken where they are free. */
export const labelOffsets: { readonly [side in Side]: Point } = {
  above: { x: 0, y: -39 },
  below: { x: 0, y: 39 },
  right: { x: 42, y: 0 },
  left: { x: -42, y: 0 },
}
/** How near the middle of a knob, of another written weight, or of a neuron's short name may come to the middle of one before they meet, in px. */
const near = { knob: { x: 34, y: 26 }, weight: { x: 48, y: 28 }, name: { x: 54, y: 31 } }

/** Half of its height, in px. */
const half = 13

/** How much of each other two things cover, in px². */
const shared = (a: Point, b: Point, { x, y }: Point) =>
  Math.max(0, x - Math.abs(a.x - b.x)) * Math.max(0, y - Math.abs(a.y - b.y))

/**
 * Where weights are written so that they cover as little as can be of knobs, of each other and of the neurons' names, inside
 * of the stage; a weight of 0 is not written.
 */
export function labelSides(
  knobs: readonly Point[],
  weights: readonly number[],
  stage: Size,
  names: readonly Point[] = [],
): readonly Side[] {
  const written: Point[] = []
  return knobs.map((knob, i) => {
    if (weights[i] === 0) return 'above'
    const covered = (at: Point) =>
      (at.y < half || at.y > stage.height - half ? near.weight.x * near.weight.y : 0) +
      knobs.reduce((sum, other) => sum + (other === knob ? 0 : shared(at, other, near.knob)), 0) +
      written.reduce((sum, other) => sum + shared(at, other, near.weight), 0) +
      names.reduce((sum, name) => sum + shared(at, name, near.name), 0)
    const places = Object.entries(labelOffsets).map(([side, off]) => {
      const at = { x: knob.x + off.x, y: knob.y + off.y }
      return { side: side as Side, at, covered: covered(at) }
    })
    const best = places.reduce((a, b) => (b.covered < a.covered ? b : a))
    written.push(best.at)
    return best.side
  })
}
