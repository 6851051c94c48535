import type { Command } from './commands.ts'
import type { Point } from './points.ts'

/** A measured way, in px of the floor's box. */
export interface Gap {
  readonly from: Point
  readonly to: Point
  readonly label: string
  /** Of the label's letters, in px. */
  readonly labelWidth: number
}

const ink = '#4A3428'
/** The measuring line stands this far below the way (cm), clear of Bo. */
const beside = 17
/** Px: shorter ways have no room for arrow heads beside their label. */
const room = 40

/** How far it is from one place to another: two dotted lines, an arrow between them and what it measures. */
export function drawGap({ from, to, label, labelWidth }: Gap, scale: number): readonly Command[] {
  const [dx, dy] = [to.x - from.x, to.y - from.y]
  const length = Math.hypot(dx, dy)
  if (length < 1) return []
  const along = { x: dx / length, y: dy / length }
  const down = along.x < 0 ? { x: along.y, y: -along.x } : { x: -along.y, y: along.x }
  const off = (at: Point, by: number) => ({ x: at.x + down.x * by, y: at.y + down.y * by })
  const away = beside * scale
  const [a, b] = [off(from, away), off(to, away)]
  const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }
  const heads = length > labelWidth + room ? [head(a, along, 1), head(b, along, -1)] : []
  return [
    dots(off(from, away * 0.5), off(from, away + 10)),
    dots(to, off(to, away + 10)),
    { kind: 'line', points: [a, b], stroke: ink, lineWidth: 3 },
    ...heads,
    ...written(heads.length > 0 ? middle : off(middle, 22), label, labelWidth),
  ]
}

const dots = (from: Point, to: Point): Command => ({
  kind: 'line',
  points: [from, to],
  stroke: ink,
  lineWidth: 3,
  dash: [0.1, 7],
})

/** `way` 1: it points back. */
function head(at: Point, along: Point, way: 1 | -1): Command {
  const wing = (side: 1 | -1) => ({
    x: at.x + 11 * (way * along.x - side * 0.7 * along.y),
    y: at.y + 11 * (way * along.y + side * 0.7 * along.x),
  })
  return { kind: 'line', points: [wing(1), at, wing(-1)], stroke: ink, lineWidth: 3 }
}

function written({ x, y }: Point, text: string, labelWidth: number): readonly Command[] {
  const width = labelWidth + 24
  const box = { x: x - width / 2, y: y - 17, width, height: 34, round: 11 }
  return [
    { kind: 'rect', ...box, fill: '#FFFDF8', stroke: ink, lineWidth: 2.5 },
    { kind: 'text', x, y: y + 7, text, size: 18, font: 'title', align: 'middle', fill: '#3A2A20' },
  ]
}
