import type { Element } from './elements.ts'
import { numbersIn } from './path.ts'
import { distance, type Point } from './point.ts'
import { stretchOf, transformed } from './transform.ts'

/** A road ends at its station's middle, in units of the drawing. */
const NEAR = 1
/** Roads that end around a picture of a station meet within this share of the drawing's diagonal. */
const MEETING = 0.015

/** A station, and how far from its middle its roads may end. */
export interface Place extends Point {
  readonly reach: number
}

/**
 * Where a station is. A circle, ellipse or rectangle: its middle. Of a picture the first place that all its roads reach:
 * where a transform of its own puts the point 0, 0, then the middles of the round shapes in it. Where they reach none: that
 * point all the same, or without a transform where the roads meet. Null where nothing tells.
 * @param inside the elements in it
 * @param ends of the roads that lead to it or away
 */
export function placeOf(
  element: Element,
  inside: readonly Element[],
  ends: readonly Point[],
  diagonal: number,
): Place | null {
  const shape = middleOf(element)
  if (shape) return shape
  const isMoved = element.attributes['transform'] !== undefined
  const own = isMoved ? [{ ...transformed(element.matrix, { x: 0, y: 0 }), reach: NEAR }] : []
  const round = inside.flatMap((one) => (one.name === 'rect' ? [] : (middleOf(one) ?? [])))
  const reached = [...own, ...round].find(({ reach, ...place }) =>
    ends.every((end) => distance(end, place) <= reach),
  )
  return reached ?? own[0] ?? meetingOf(ends, diagonal)
}

function middleOf({ name, attributes, matrix }: Element): Place | null {
  const at = (one: string) => numberOf(attributes[one] ?? '0')
  const [x, y] =
    name === 'rect' ? [at('x') + at('width') / 2, at('y') + at('height') / 2] : [at('cx'), at('cy')]
  const radii = {
    circle: [at('r')],
    ellipse: [at('rx'), at('ry')],
    rect: [at('width') / 2, at('height') / 2],
  }
  if (name !== 'circle' && name !== 'ellipse' && name !== 'rect') return null
  const reach = Math.max(NEAR, ...radii[name].map((radius) => radius * stretchOf(matrix)))
  const place = { ...transformed(matrix, { x, y }), reach }
  return Object.values(place).every(Number.isFinite) ? place : null
}

/** A length of the drawing; NaN for other units and words. */
const numberOf = (text: string): number => numbersIn(text.replace(/px$/, ''))?.[0] ?? NaN

function meetingOf(ends: readonly Point[], diagonal: number): Place | null {
  if (ends.length === 0) return null
  const sum = ends.reduce((all, end) => ({ x: all.x + end.x, y: all.y + end.y }))
  const reach = Math.max(NEAR, MEETING * diagonal)
  return { x: sum.x / ends.length, y: sum.y / ends.length, reach }
}
