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

/** `scale`: pixels of the canvas to one of the page. */
export function draw(context: CanvasRenderingContext2D, drawing: Drawing, scale: number): void {
  context.setTransform(scale, 0, 0, scale, 0, 0)
  context.clearRect(0, 0, context.canvas.width, context.canvas.height)
  const groups: Spot[][] = drawing.flags.map(() => [])
  drawing.spots.forEach((spot, at) => groups[drawing.labels[at] ?? -1]?.push(spot))
  groups.forEach((spots, group) => drawArea(context, spots, group, drawing.dot === 0 ? 34 : 16))
  if (drawing.threads)
    groups.forEach((spots, group) => drawThreads(context, spots, drawing.flags[group]!, group))
  if (drawing.dot > 0) drawDots(context, drawing, scale)
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

/** A dot is drawn once a group and then stamped, pixel on pixel: thousands fit in a frame. */
function drawDots(context: CanvasRenderingContext2D, drawing: Drawing, scale: number): void {
  const { spots, labels, dot, fills } = drawing
  const stamps = [-1, ...groupLooks.keys()].map((group) => stampOf(group, dot, fills !== null, scale))
  context.setTransform(1, 0, 0, 1, 0, 0)
  spots.forEach(({ x, y }, at) => {
    const stamp = stamps[(labels[at] ?? -1) + 1]!
    const middle = stamp.width / 2
    context.drawImage(stamp, Math.round(x * scale - middle), Math.round(y * scale - middle))
    if (fills) fillDot(context, x * scale, y * scale, (dot - 1) * scale, fills[at]!)
  })
}

const kept = new Map<string, HTMLCanvasElement>()

function stampOf(group: number, dot: number, hollow: boolean, scale: number): HTMLCanvasElement {
  const key = `${group} ${dot} ${hollow} ${scale}`
  const stamp = kept.get(key) ?? freshStamp(group, dot, hollow, scale)
  kept.set(key, stamp)
  return stamp
}

function freshStamp(group: number, dot: number, hollow: boolean, scale: number): HTMLCanvasElement {
  const stamp = document.createElement('canvas')
  const middle = Math.ceil((1.5 * dot + 2) * scale)
  stamp.width = stamp.height = 2 * middle
  const context = stamp.getContext('2d')!
  context.setTransform(scale, 0, 0, scale, middle, middle)
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
