import type { Command, Font, Group, Ink, Letters, Rect, Stripes } from './commands.ts'
import { pictureOf } from './picture.ts'

// One shape on a canvas: its outline, its ink, its letters.

/** What a canvas must be able to do. */
export type Canvas = Pick<
  CanvasRenderingContext2D,
  | 'arc'
  | 'beginPath'
  | 'closePath'
  | 'createPattern'
  | 'drawImage'
  | 'ellipse'
  | 'fill'
  | 'fillStyle'
  | 'fillText'
  | 'font'
  | 'getTransform'
  | 'globalAlpha'
  | 'lineCap'
  | 'lineJoin'
  | 'lineTo'
  | 'lineWidth'
  | 'moveTo'
  | 'resetTransform'
  | 'roundRect'
  | 'setLineDash'
  | 'setTransform'
  | 'stroke'
  | 'strokeStyle'
  | 'textAlign'
>

/** Family names of letters as CSS has them. */
export type Families = { readonly [font in Font]: string }

/** So many paths are remembered: a drawing of a thing has some ten of them. */
const mostPaths = 2_000
const paths = new Map<string, Path2D>()
const solid: readonly number[] = []

function pathOf(d: string): Path2D {
  const known = paths.get(d)
  if (known) return known
  if (paths.size >= mostPaths) paths.clear()
  const path = new Path2D(d)
  paths.set(d, path)
  return path
}

type Shape = Exclude<Command, Group>

export function paintShape(canvas: Canvas, command: Shape, families: Families, opacity: number): void {
  canvas.globalAlpha = opacity
  if (command.kind === 'text') return write(canvas, command, families)
  if (command.kind === 'path') return ink(canvas, command, pathOf(command.d))
  canvas.beginPath()
  if (command.kind === 'circle')
    canvas.ellipse(command.x, command.y, command.r, command.ry ?? command.r, 0, 0, 2 * Math.PI)
  else if (command.kind === 'rect') outline(canvas, command)
  else if (command.kind === 'lines') trace(canvas, command.points)
  else {
    command.points.forEach(({ x, y }, i) => (i === 0 ? canvas.moveTo(x, y) : canvas.lineTo(x, y)))
    if (command.closed) canvas.closePath()
  }
  ink(canvas, command)
}

function outline(canvas: Canvas, { x, y, width, height, round = 0 }: Rect): void {
  // As SVG has it, and a canvas would not: corners are never rounder than half a side.
  canvas.roundRect(x, y, width, height, Math.min(round, width / 2, height / 2))
}

function trace(canvas: Canvas, points: Float32Array): void {
  let begins = true
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = [points[i]!, points[i + 1]!]
    if (Number.isNaN(x)) begins = true
    else if (begins) {
      canvas.moveTo(x, y)
      begins = false
    } else canvas.lineTo(x, y)
  }
}

function ink(canvas: Canvas, look: Ink, path?: Path2D): void {
  const { fill, stroke, lineWidth = 1, dash = solid } = look
  if (fill !== undefined) {
    canvas.fillStyle = fill
    if (path) canvas.fill(path)
    else canvas.fill()
  }
  if (stroke === undefined) return
  canvas.strokeStyle = look.stripes ? patternOf(canvas, look.stripes) : stroke
  canvas.lineCap = look.flat ? 'butt' : 'round'
  canvas.lineWidth = lineWidth
  canvas.setLineDash(dash as number[])
  if (path) canvas.stroke(path)
  else canvas.stroke()
}

const patterns = new Map<string, CanvasPattern>()
/** Tiles are so much finer than what they are painted on. */
const tileScale = 4

function patternOf(canvas: Canvas, { on, colour, every, width }: Stripes): CanvasPattern {
  const key = [on, colour, every, width].join()
  const known = patterns.get(key)
  if (known) return known
  const side = every * tileScale
  const tile = pictureOf(side, side, (context) => {
    context.fillStyle = on
    context.fillRect(0, 0, side, side)
    context.fillStyle = colour
    context.fillRect(0, 0, width * tileScale, side)
  })
  const pattern = canvas.createPattern(tile, 'repeat')!
  pattern.setTransform(new DOMMatrix().rotate(45).scale(1 / tileScale))
  patterns.set(key, pattern)
  return pattern
}

const alignments = { start: 'left', middle: 'center', end: 'right' } as const

/** A font as a canvas writes it, by how it was given. */
const fonts = new Map<string, string>()

function write(canvas: Canvas, letters: Letters, families: Families): void {
  const font = `${letters.weight ?? 700} ${letters.size}px ${families[letters.font]}`
  // To set even the same font makes a browser look through the page's styles first.
  if (canvas.font !== fonts.get(font)) {
    canvas.font = font
    fonts.set(font, canvas.font)
  }
  canvas.textAlign = alignments[letters.align ?? 'start']
  canvas.fillStyle = letters.fill ?? '#000'
  canvas.fillText(letters.text, letters.x, letters.y)
}
