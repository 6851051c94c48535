import type { Spot } from './hull.ts'
import { hullOf } from './hull.ts'
import { formOf, groupLooks } from './looks.ts'
import { coloured, stampOf, stampOnto, type Pixels, type Stamp } from './pixels.ts'

/** What lies under flags and things: areas of the groups, threads to the flags, dots. */
export interface Drawing {
  readonly spots: readonly Spot[]
  readonly labels: readonly number[]
  readonly flags: readonly Spot[]
  /** Radius of a dot; 0: things are drawn by others. */
  readonly dot: number
  /** By point, the colour a dot is filled with as red, green and blue; its group's where nothing is said. */
  readonly fills: readonly (readonly number[])[] | null
  readonly threads: boolean
}

const unsorted = '#8C7152'

/** Areas and threads. `scale`: pixels of the canvas to one of the page. */
export function drawAreas(context: CanvasRenderingContext2D, drawing: Drawing, scale: number): void {
  context.setTransform(scale, 0, 0, scale, 0, 0)
  context.clearRect(0, 0, context.canvas.width, context.canvas.height)
  const groups: Spot[][] = drawing.flags.map(() => [])
  drawing.spots.forEach((spot, at) => groups[drawing.labels[at] ?? -1]?.push(spot))
  groups.forEach((spots, group) => drawArea(context, spots, group, drawing.dot === 0 ? 34 : 16))
  if (drawing.threads)
    groups.forEach((spots, group) => drawThreads(context, spots, drawing.flags[group]!, group))
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

/** A dot is drawn once a group and then stamped into memory: thousands fit in a frame. */
export function drawDots(context: CanvasRenderingContext2D, drawing: Drawing, scale: number): void {
  const { spots, labels, dot, fills } = drawing
  const { width, height } = context.canvas
  const onto = context.createImageData(width, height)
  const dots = [-1, ...groupLooks.keys()].map((group) => dotOf(group, dot * scale, fills !== null, width))
  const inner = dotOf(0, (dot - 1) * scale, false, width)
  const put = (stamp: Stamp, { x, y }: Spot) =>
    stampOnto(onto, stamp, Math.round(x * scale - stamp.width / 2), Math.round(y * scale - stamp.height / 2))
  spots.forEach((spot, at) => {
    put(dots[(labels[at] ?? -1) + 1]!, spot)
    if (fills) put(coloured(inner, fills[at]!), spot)
  })
  context.putImageData(onto, 0, 0)
}

let kept = new Map<string, Stamp>()
let keptFor = 0

/** `ring`: its middle shows another colour. `width`: of the canvas. */
function dotOf(group: number, radius: number, ring: boolean, width: number): Stamp {
  if (keptFor !== width) kept = new Map()
  keptFor = width
  const key = `${group} ${radius} ${ring}`
  const stamp = kept.get(key) ?? stampOf(freshDot(group, radius, ring), width)
  kept.set(key, stamp)
  return stamp
}

function freshDot(group: number, radius: number, ring: boolean): Pixels {
  const canvas = document.createElement('canvas')
  const middle = Math.ceil(1.5 * radius + 4)
  canvas.width = canvas.height = 2 * middle
  const context = canvas.getContext('2d')!
  context.translate(middle, middle)
  const form = new Path2D(formOf(group, radius))
  context.fillStyle = context.strokeStyle = groupLooks[group]?.colour ?? unsorted
  context.lineWidth = ring ? radius * 0.6 : Math.max(1.5, radius * 0.19)
  if (!ring) {
    context.fill(form)
    context.strokeStyle = '#4A3428'
  }
  context.stroke(form)
  return context.getImageData(0, 0, canvas.width, canvas.height)
}
