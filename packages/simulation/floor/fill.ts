import type { Cm, Colour, Floor } from '../types.ts'

// Own scan lines without anti-aliasing (running.md 6): a pixel is painted when its middle lies inside.

export type Point = readonly [x: Cm, y: Cm]

/** `#RRGGBB` as three bytes. */
export function bytesOf(colour: Colour): readonly [number, number, number] {
  const all = Number.parseInt(colour.slice(1), 16)
  return [(all >> 16) & 0xff, (all >> 8) & 0xff, all & 0xff]
}

/** Paints a convex polygon; its corners in either sense of rotation. */
export function fillPolygon(floor: Floor, corners: readonly Point[], colour: Colour): void {
  const heights = corners.map(([, y]) => y)
  const bytes = bytesOf(colour)
  forRows(floor, Math.min(...heights), Math.max(...heights), (row, y) => {
    let left = Infinity
    let right = -Infinity
    corners.forEach((from, index) => {
      const x = crossing(from, corners[(index + 1) % corners.length]!, y)
      if (x === null) return
      left = Math.min(left, x)
      right = Math.max(right, x)
    })
    fillRow(floor, row, left, right, bytes)
  })
}

export function fillCircle(floor: Floor, [x, y]: Point, radius: Cm, colour: Colour): void {
  const bytes = bytesOf(colour)
  forRows(floor, y - radius, y + radius, (row, middle) => {
    const half = Math.sqrt(Math.max(0, radius * radius - (middle - y) * (middle - y)))
    fillRow(floor, row, x - half, x + half, bytes)
  })
}

/** Where an edge crosses a height: each edge has its lower end, not its upper one. */
function crossing([ax, ay]: Point, [bx, by]: Point, y: Cm): Cm | null {
  if (ay === by || y < Math.min(ay, by) || y >= Math.max(ay, by)) return null
  return ax + ((y - ay) / (by - ay)) * (bx - ax)
}

/** Calls back for every row whose middle lies between two heights. */
function forRows(floor: Floor, low: Cm, high: Cm, paint: (row: number, middle: Cm) => void): void {
  const { height, pixelsPerCm } = floor
  const first = Math.max(0, Math.ceil(height - high * pixelsPerCm - 0.5))
  const last = Math.min(height - 1, Math.floor(height - low * pixelsPerCm - 0.5))
  for (let row = first; row <= last; row++) paint(row, (height - row - 0.5) / pixelsPerCm)
}

type Bytes = ReturnType<typeof bytesOf>

function fillRow({ data, width, pixelsPerCm }: Floor, row: number, left: Cm, right: Cm, bytes: Bytes): void {
  const first = Math.max(0, Math.ceil(left * pixelsPerCm - 0.5))
  const end = row * width + Math.min(width, Math.ceil(right * pixelsPerCm - 0.5))
  const [red, green, blue] = bytes
  for (let at = (row * width + first) * 3; at < end * 3; at += 3) {
    data[at] = red
    data[at + 1] = green
    data[at + 2] = blue
  }
}
