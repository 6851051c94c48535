import type { Spot } from './hull.ts'
import { hullOf } from './hull.ts'
import { formOf, groupLooks } from './looks.ts'

/** What lies under flags and things: areas of the groups, threads to the flags, dots. */
export interface Drawing {
  readonly spots: readonly Spot[]
  readonly labels: readonly number[]
  readonly flags: readonly Spot[]
  /** Radius of a dot; 0: things are drawn by others. */
  readonly dot: number
  /** By point, the colour a dot is filled with; its group's where nothing is said. */
  readonly fills: readonly string[] | null
  readonly threads: boolean
}

const unsorted = '#8C7152'

export function draw(context: CanvasRenderingContext2D, drawing: Drawing): void {
  const groups = drawing.flags.map((_, group) =>
    drawing.spots.filter((_, at) => drawing.labels[at] === group),
  )
  groups.forEach((spots, group) => drawArea(context, spots, group, drawing.dot === 0 ? 34 : 16))
  if (drawing.threads)
    groups.forEach((spots, group) => drawThreads(context, spots, drawing.flags[group]!, group))
  if (drawing.dot > 0) drawDots(context, drawing)
}

/** A soft area: the hull with a broad round rim of the same tint. */
function drawArea(
  context: CanvasRenderingContext2D,
  spots: readonly Spot[],
  group: number,
  rim: number,
): void {
  if (spots.length === 0) return
  const hull = hullOf(spots)
  context.beginPath()
  hull.forEach(({ x, y }, at) => (at === 0 ? context.moveTo(x, y) : context.lineTo(x, y)))
  context.closePath()
  context.lineJoin = context.lineCap = 'round'
  context.lineWidth = 2 * rim
  context.strokeStyle = context.fillStyle = groupLooks[group]!.tint
  context.stroke()
  context.fill()
}

function drawThreads(
  context: CanvasRenderingContext2D,
  spots: readonly Spot[],
  flag: Spot,
  group: number,
): void {
  context.beginPath()
  for (const { x, y } of spots) {
    context.moveTo(flag.x, flag.y)
    context.lineTo(x, y)
  }
  context.setLineDash([6, 6])
  context.lineWidth = 2
  context.strokeStyle = groupLooks[group]!.colour
  context.stroke()
  context.setLineDash([])
}

/** A dot is drawn once a group and then stamped: thousands fit in a frame. */
function drawDots(context: CanvasRenderingContext2D, { spots, labels, dot, fills }: Drawing): void {
  const stamps = [-1, ...groupLooks.keys()].map((group) => stampOf(group, dot, fills !== null))
  const middle = stampSize(dot) / 2
  spots.forEach(({ x, y }, at) => {
    const stamp = stamps[(labels[at] ?? -1) + 1]!
    context.drawImage(stamp, x - middle, y - middle, 2 * middle, 2 * middle)
    if (fills) fillDot(context, x, y, dot - 1, fills[at]!)
  })
}

const stampSize = (dot: number) => Math.ceil(3 * dot + 8)
const kept = new Map<string, HTMLCanvasElement>()

function stampOf(group: number, dot: number, hollow: boolean): HTMLCanvasElement {
  const key = `${group} ${dot} ${hollow}`
  const stamp = kept.get(key) ?? freshStamp(group, dot, hollow)
  kept.set(key, stamp)
  return stamp
}

function freshStamp(group: number, dot: number, hollow: boolean): HTMLCanvasElement {
  const stamp = document.createElement('canvas')
  const size = stampSize(dot)
  stamp.width = stamp.height = 2 * size
  const context = stamp.getContext('2d')!
  context.setTransform(2, 0, 0, 2, size, size)
  const form = new Path2D(formOf(group, dot))
  context.fillStyle = context.strokeStyle = groupLooks[group]?.colour ?? unsorted
  context.lineWidth = hollow ? 5 : 1.5
  if (!hollow) {
    context.fill(form)
    context.strokeStyle = '#4A3428'
  }
  context.stroke(form)
  return stamp
}

function fillDot(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  radius: number,
  fill: string,
): void {
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
  context.fillStyle = fill
  context.fill()
}
