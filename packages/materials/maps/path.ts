import { atan2 } from '@botgarten/numbers'

interface Point {
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

/**
 * A road's centre line: `M`, then straight lines `L` and circular arcs `A`, absolute. Lengths are exact: an arc's is
 * radius times angle. Null for any other path.
 */
export function readPath(data: string): PathShape | null {
  const pieces = data.match(/[a-z][^a-z]*/gi) ?? []
  if (pieces.join('').trim() !== data.trim() || !pieces[0]?.startsWith('M')) return null
  let from: Point | null = null
  let at: Point = { x: 0, y: 0 }
  let length = 0
  for (const piece of pieces) {
    const values = numbersIn(piece.slice(1))
    const kind = piece[0]!
    const many = { M: 2, L: 2, A: 7 }[kind]
    if (many === undefined || values === null || values.length === 0 || values.length % many !== 0)
      return null
    for (let index = 0; index < values.length; index += many) {
      const [x, y] = values.slice(index + many - 2) as [number, number]
      if (kind === 'M' && from !== null) return null
      if (kind === 'L') length += distance(at, { x, y })
      if (kind === 'A') {
        const arc = arcLength(at, values.slice(index, index + 7))
        if (arc === null) return null
        length += arc
      }
      at = { x, y }
      from ??= at
    }
  }
  return from && { from, to: at, length }
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

/** SVG 1.1, F.6: of the two arcs that join two points, the large or the small one. Too small a radius grows. */
function arcLength(from: Point, [rx, ry, , large, , x, y]: number[]): number | null {
  if (rx !== ry || !(rx! > 0)) return null
  const half = distance(from, { x: x!, y: y! }) / 2
  const radius = Math.max(rx!, half)
  const angle = 2 * atan2(half, Math.sqrt(radius * radius - half * half))
  return radius * (large ? 2 * Math.PI - angle : angle)
}

export function distance(a: Point, b: Point): number {
  const [x, y] = [a.x - b.x, a.y - b.y]
  return Math.sqrt(x * x + y * y)
}
