import { cos, sin, tan } from '@botgarten/numbers'
import { numbersIn } from './path.ts'
import type { Point } from './point.ts'

/** An affine map as SVG writes it: x′ = a·x + c·y + e, y′ = b·x + d·y + f. */
export type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number]

export const identity: Matrix = [1, 0, 0, 1, 0, 0]

/** The one that does `inner` first, then `outer`. */
export function compose(outer: Matrix, inner: Matrix): Matrix {
  const [a, b, c, d, e, f] = outer
  const [p, q, r, s, t, u] = inner
  return [a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f]
}

export const transformed = ([a, b, c, d, e, f]: Matrix, { x, y }: Point): Point => ({
  x: a * x + c * y + e,
  y: b * x + d * y + f,
})

/** No length grows by more than this. */
export const stretchOf = ([a, b, c, d]: Matrix): number => Math.sqrt(a * a + b * b + c * c + d * d)

const radians = (degrees: number) => (degrees * Math.PI) / 180

const moved = (x: number, y = 0): Matrix => [1, 0, 0, 1, x, y]
function rotated(degrees: number): Matrix {
  const [c, s] = [cos(radians(degrees)), sin(radians(degrees))]
  return [c, s, -s, c, 0, 0]
}
const tangent = (degrees: number) => tan(radians(degrees))

/** By how many numbers each takes. */
const kinds: { readonly [name: string]: { readonly [count: number]: (...values: number[]) => Matrix } } = {
  matrix: { 6: (...values) => values as unknown as Matrix },
  translate: { 1: moved, 2: moved },
  scale: { 1: (both) => [both, 0, 0, both, 0, 0], 2: (x, y) => [x, 0, 0, y, 0, 0] },
  rotate: {
    1: rotated,
    3: (degrees, x, y) => compose(compose(moved(x, y), rotated(degrees)), moved(-x, -y)),
  },
  skewX: { 1: (degrees) => [1, 0, tangent(degrees), 1, 0, 0] },
  skewY: { 1: (degrees) => [1, tangent(degrees), 0, 1, 0, 0] },
}

/** Characters of one transform. */
const LONGEST = 2_000

/** What a `transform` attribute says (SVG 1.1, 7.6); null where it cannot be read. */
export function matrixOf(text: string): Matrix | null {
  if (text.length > LONGEST) return null
  const one = /[\s,]*([a-z]+)\s*\(([^()]*)\)\s*/iy
  let all = identity
  let end = 0
  for (let found = one.exec(text); found !== null; found = one.exec(text)) {
    end = one.lastIndex
    const values = numbersIn(found[2]!)
    const make = kinds[found[1]!]?.[values?.length ?? 0]
    if (!values || !make) return null
    all = compose(all, make(...values))
  }
  return text.slice(end).trim() === '' && all.every(Number.isFinite) ? all : null
}
