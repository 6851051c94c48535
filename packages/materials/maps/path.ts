import { atan2, cos, sin } from '@botgarten/numbers'

export interface Point {
  readonly x: number
  readonly y: number
}

export interface PathShape {
  readonly from: Point
  readonly to: Point
  /** In units of the drawing. */
  readonly length: number
}

const number = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/i

/** A straight line (radius null), or a circular arc as SVG writes it. */
export interface Segment {
  readonly from: Point
  readonly to: Point
  readonly arc: { readonly radius: number; readonly large: boolean; readonly sweep: boolean } | null
}

/**
 * A road's centre line: `M`, then straight lines `L` and circular arcs `A`, absolute. Lengths are exact: an arc's is
 * radius times angle. Null for any other path.
 */
export function readPath(data: string): PathShape | null {
  const segments = segmentsOf(data)
  if (segments === null) return null
  const length = segments.reduce((sum, segment) => sum + lengthOf(segment), 0)
  return { from: segments[0]!.from, to: segments.at(-1)!.to, length }
}

/** The segments of such a path; of one that never leaves its place a single one of length 0. Null for any other path. */
export function segmentsOf(data: string): readonly Segment[] | null {
  const pieces = data.match(/[a-z][^a-z]*/gi) ?? []
  if (pieces.join('').trim() !== data.trim() || !pieces[0]?.startsWith('M')) return null
  const segments: Segment[] = []
  let at: Point | null = null
  for (const piece of pieces) {
    const values = numbersIn(piece.slice(1))
    const kind = piece[0]!
    const many = { M: 2, L: 2, A: 7 }[kind]
    if (many === undefined || values === null || values.length === 0 || values.length % many !== 0)
      return null
    for (let index = 0; index < values.length; index += many) {
      const next = segmentTo(at, kind, values.slice(index, index + many))
      if (next === null) return null
      if (at !== null) segments.push(next)
      at = next.to
    }
  }
  return segments.length > 0 ? segments : at && [{ from: at, to: at, arc: null }]
}

function segmentTo(at: Point | null, kind: string, values: readonly number[]): Segment | null {
  const [x, y] = values.slice(-2) as [number, number]
  const to = { x, y }
  if (kind === 'M') return at === null ? { from: to, to, arc: null } : null
  if (at === null) return null
  if (kind === 'L') return { from: at, to, arc: null }
  const [rx, ry, , large, sweep] = values
  if (rx !== ry || !(rx! > 0)) return null
  const radius = Math.max(rx!, distance(at, to) / 2)
  return { from: at, to, arc: { radius, large: Boolean(large), sweep: Boolean(sweep) } }
}

function numbersIn(text: string): number[] | null {
  const values: number[] = []
  let rest = text.trim()
  while (rest !== '') {
    const found = number.exec(rest)?.[0]
    if (found === undefined) return null
    values.push(Number(found))
    rest = rest.slice(found.length).replace(/^[\s,]+/, '')
  }
  return values
}

/** SVG 1.1, F.6: of the two arcs that join two points, the large or the small one. Too small a radius has grown. */
function lengthOf({ from, to, arc }: Segment): number {
  const half = distance(from, to) / 2
  if (arc === null) return 2 * half
  const angle = 2 * atan2(half, Math.sqrt(Math.max(0, arc.radius * arc.radius - half * half)))
  return arc.radius * (arc.large ? 2 * Math.PI - angle : angle)
}

/** Points of a segment about `step` apart, without its first. */
export function pointsAlong(segment: Segment, step: number): Point[] {
  const { from, to, arc } = segment
  const count = Math.max(1, Math.ceil(lengthOf(segment) / step))
  const shares = Array.from({ length: count }, (_, index) => (index + 1) / count)
  if (arc === null) return shares.map((share) => between(from, to, share))
  const centre = centreOf(from, to, arc)
  const angle = (lengthOf(segment) / arc.radius) * (arc.sweep ? 1 : -1)
  return [...shares.slice(0, -1).map((share) => turned(from, centre, angle * share)), to]
}

export const between = (a: Point, b: Point, share: number): Point => ({
  x: a.x + (b.x - a.x) * share,
  y: a.y + (b.y - a.y) * share,
})

function centreOf(from: Point, to: Point, { radius, large, sweep }: NonNullable<Segment['arc']>): Point {
  const chord = distance(from, to)
  const height = Math.sqrt(Math.max(0, radius * radius - (chord * chord) / 4))
  const side = (large === sweep ? 1 : -1) * (chord > 0 ? height / chord : 0)
  const middle = between(from, to, 0.5)
  return { x: middle.x + (to.y - from.y) * side, y: middle.y - (to.x - from.x) * side }
}

function turned(point: Point, { x, y }: Point, angle: number): Point {
  const [dx, dy, c, s] = [point.x - x, point.y - y, cos(angle), sin(angle)]
  return { x: x + dx * c - dy * s, y: y + dx * s + dy * c }
}

export function distance(a: Point, b: Point): number {
  const [x, y] = [a.x - b.x, a.y - b.y]
  return Math.sqrt(x * x + y * y)
}
