import { hullOf, type Spot } from '../model/geometry.ts'
import type { Dots, Drawing } from '../model/plane.svelte.ts'

/** By group: colour of flag and dots, a tint for its area, a shade for words on that tint. */
export const groupLooks = [
  { colour: '#E4604A', tint: '#FBE0DA', text: '#8E2A12' },
  { colour: '#1E8A83', tint: '#D8EFEA', text: '#0F635E' },
  { colour: '#D99A12', tint: '#FBE9C0', text: '#6E4A00' },
  { colour: '#6F55C4', tint: '#E6E0F7', text: '#4A3494' },
  { colour: '#2C6FB0', tint: '#DCE9F6', text: '#1D4E80' },
  { colour: '#7B5B45', tint: '#EBDFD5', text: '#553B29' },
] as const

/** Outline of a dot of radius r round 0, 0: a form of its own for each group, so that colour is not all. */
const forms: readonly ((r: number) => string)[] = [
  (r) => `M${r} 0A${r} ${r} 0 1 1 ${-r} 0A${r} ${r} 0 1 1 ${r} 0Z`,
  (r) => `M${-r * 0.9} ${-r * 0.9}H${r * 0.9}V${r * 0.9}H${-r * 0.9}Z`,
  (r) => `M0 ${-r * 1.2}L${r * 1.1} ${r * 0.8}H${-r * 1.1}Z`,
  (r) => `M0 ${-r * 1.3}L${r * 1.3} 0L0 ${r * 1.3}L${-r * 1.3} 0Z`,
  (r) => `M0 ${r * 1.2}L${r * 1.1} ${-r * 0.8}H${-r * 1.1}Z`,
  (r) =>
    `M${-r * 1.2} ${-r * 0.45}H${-r * 0.45}V${-r * 1.2}H${r * 0.45}V${-r * 0.45}H${r * 1.2}V${r * 0.45}H${r * 0.45}V${r * 1.2}H${-r * 0.45}V${r * 0.45}H${-r * 1.2}Z`,
]

/** Form of a group's dots; −1: in no group yet. */
export const formOf = (group: number, radius: number): string => (forms[group] ?? forms[0]!)(radius)

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

/** So many dots are stamped before the page gets its turn. */
export const dotsAtOnce = 500

/**
 * A dot is drawn once a group and then stamped into memory; the picture is shown when all of them are. Asked for step by
 * step, thousands keep no frame waiting.
 */
export function* drawDots(context: CanvasRenderingContext2D, drawing: Dots, scale: number): Generator<void> {
  const { spots, labels, dot, fills } = drawing
  const { width, height } = context.canvas
  const onto = context.createImageData(width, height)
  const dots = [-1, ...groupLooks.keys()].map((group) => dotOf(group, dot * scale, fills !== null, width))
  const inner = dotOf(0, (dot - 1) * scale, false, width)
  const put = (stamp: Stamp, { x, y }: Spot) =>
    stampOnto(onto, stamp, Math.round(x * scale - stamp.width / 2), Math.round(y * scale - stamp.height / 2))
  for (const [at, spot] of spots.entries()) {
    put(dots[(labels[at] ?? -1) + 1]!, spot)
    if (fills) put(coloured(inner, fills[at]!), spot)
    if (at % dotsAtOnce === dotsAtOnce - 1) yield
  }
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

// ---- pixels ----

/** A picture in memory: red, green, blue and alpha of every pixel, row by row. */
export interface Pixels {
  readonly width: number
  readonly height: number
  readonly data: Uint8ClampedArray
}

/** A small picture, ready to be laid over one of this width many times: its pixels that are not clear, and where they go. */
export interface Stamp {
  readonly width: number
  readonly height: number
  /** From the upper left corner, in pixels of the large picture. */
  readonly steps: Int32Array
  /** Red, green, blue and alpha of each. */
  readonly parts: Uint8ClampedArray
}

export function stampOf({ width, height, data }: Pixels, ontoWidth: number): Stamp {
  const seen = Array.from({ length: width * height }, (_, at) => at).filter((at) => data[4 * at + 3] !== 0)
  return {
    ...{ width, height },
    steps: Int32Array.from(seen, (at) => Math.floor(at / width) * ontoWidth + (at % width)),
    parts: Uint8ClampedArray.from(seen.flatMap((at) => [...data.subarray(4 * at, 4 * at + 4)])),
  }
}

/** The same shape in another colour. */
export const coloured = ({ parts, ...stamp }: Stamp, [red, green, blue]: readonly number[]): Stamp => ({
  ...stamp,
  parts: parts.map((part, at) => [red!, green!, blue!, part][at % 4]!),
})

/**
 * Lays a stamp over a picture, its upper left corner at x, y; one that hangs over the rim is left out. Browsers do the same
 * with `drawImage`, but take far longer for thousands.
 */
export function stampOnto(onto: Pixels, { width, height, steps, parts }: Stamp, x: number, y: number): void {
  if (x < 0 || y < 0 || x + width > onto.width || y + height > onto.height) return
  const { data } = onto
  const corner = y * onto.width + x
  for (let at = 0; at < steps.length; at++) {
    const to = 4 * (corner + steps[at]!)
    const from = 4 * at
    if (parts[from + 3] === 255 || data[to + 3] === 0) {
      data[to] = parts[from]!
      data[to + 1] = parts[from + 1]!
      data[to + 2] = parts[from + 2]!
      data[to + 3] = parts[from + 3]!
    } else over(data, to, parts, from)
  }
}

/** One pixel over another, neither of them multiplied by its alpha (Porter & Duff 1984). */
function over(below: Uint8ClampedArray, to: number, above: Uint8ClampedArray, from: number): void {
  const cover = above[from + 3]! / 255
  const rest = (below[to + 3]! / 255) * (1 - cover)
  const whole = cover + rest
  for (let part = 0; part < 3; part++)
    below[to + part] = (above[from + part]! * cover + below[to + part]! * rest) / whole
  below[to + 3] = 255 * whole
}
