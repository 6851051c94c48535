import { atan2, cos, sin } from '@botgarten/numbers'
import { curveLength, evenly } from './curve.ts'
import { between, distance, type Point } from './point.ts'

export interface PathShape {
  readonly from: Point
  readonly to: Point
  /** In units of the drawing. */
  readonly length: number
}

/** A straight line, a circular arc as SVG writes it, or a cubic Bézier curve by the two points that pull it. */
export interface Segment {
  readonly from: Point
  readonly to: Point
  readonly arc: { readonly radius: number; readonly large: boolean; readonly sweep: boolean } | null
  readonly curve?: readonly [Point, Point]
}

/**
 * A road's centre line: `M`, then straight lines `L`, circular arcs `A` and cubic curves `C`, absolute. Lengths of lines
 * and arcs are exact: an arc's is radius times angle. Null for any other path.
 */
export function readPath(data: string): PathShape | null {
  const segments = segmentsOf(data)
  if (segments === null) return null
  const length = segments.reduce((sum, segment) => sum + lengthOf(segment), 0)
  return { from: segments[0]!.from, to: segments.at(-1)!.to, length }
}

/** The segments of such a path; of one that never leaves its place a single one of length 0. Null for any other path. */
export function segmentsOf(data: string): readonly Segment[] | null {
  const pieces = data.match(/[a-df-z][^a-df-z]*/gi) ?? []
  if (pieces.join('').trim() !== data.trim() || !pieces[0]?.startsWith('M')) return null
  const segments: Segment[] = []
  let at: Point | null = null
  for (const piece of pieces) {
    const values = numbersIn(piece.slice(1))
    const kind = piece[0]!
    const many = { M: 2, L: 2, A: 7, C: 6 }[kind]
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
  if (kind === 'C') {
    const [a, b, c, d] = values as [number, number, number, number]
    return {
      from: at,
      to,
      arc: null,
      curve: [
        { x: a, y: b },
        { x: c, y: d },
      ],
    }
  }
  const [rx, ry, , large, sweep] = values
  if (rx !== ry || !(rx! > 0) || ![large, sweep].every((flag) => flag === 0 || flag === 1)) return null
  const radius = Math.max(rx!, distance(at, to) / 2)
  return { from: at, to, arc: { radius, large: Boolean(large), sweep: Boolean(sweep) } }
}

/** Numbers with white space or commas between them; null where anything else stands there. */
export function numbersIn(text: string): number[] | null {
  const number = /[\s,]*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)/iy
  const values: number[] = []
  let end = 0
  for (let found = number.exec(text); found !== null; found = number.exec(text)) {
    values.push(Number(found[1]))
    end = number.lastIndex
  }
  return /^[\s,]*$/.test(text.slice(end)) ? values : null
}

/** SVG 1.1, F.6: of the two arcs that join two points, the large or the small one. Too small a radius has grown. */
function lengthOf({ from, to, arc, curve }: Segment): number {
  if (curve) return curveLength([from, ...curve, to])
  const half = distance(from, to) / 2
  if (arc === null) return 2 * half
  const angle = 2 * atan2(half, Math.sqrt(Math.max(0, arc.radius * arc.radius - half * half)))
  return arc.radius * (arc.large ? 2 * Math.PI - angle : angle)
}

/** Points of a segment about `step` apart, without its first. */
export function pointsAlong(segment: Segment, step: number): Point[] {
  const { from, to, arc, curve } = segment
  const count = Math.max(1, Math.ceil(lengthOf(segment) / step))
  if (curve) return evenly([from, ...curve, to], count)
  const shares = Array.from({ length: count }, (_, index) => (index + 1) / count)
  if (arc === null) return shares.map((share) => between(from, to, share))
  const centre = centreOf(from, to, arc)
  const angle = (lengthOf(segment) / arc.radius) * (arc.sweep ? 1 : -1)
  return [...shares.slice(0, -1).map((share) => turned(from, centre, angle * share)), to]
}

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
