import { scales, type Command, type Font, type Group, type Ink, type Letters, type Rect } from './commands.ts'

/** What a canvas must be able to do. */
export type Canvas = Pick<
  CanvasRenderingContext2D,
  | 'arc'
  | 'beginPath'
  | 'closePath'
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
  | 'restore'
  | 'rotate'
  | 'roundRect'
  | 'save'
  | 'scale'
  | 'setLineDash'
  | 'stroke'
  | 'strokeStyle'
  | 'textAlign'
  | 'translate'
>

/** Another canvas as large as the one that is painted on, and empty. */
export type Layer = () => CanvasRenderingContext2D

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

/** What paints, and with what. */
interface Tools {
  readonly families: Families
  readonly layer: Layer | undefined
}

/**
 * Paints commands one after the other, onto what is there. Leaves the canvas as it found it.
 * @param layer a group that is pale is painted there first, so that it is pale as one; without it each shape is
 */
export function paint(canvas: Canvas, commands: readonly Command[], families: Families, layer?: Layer): void {
  canvas.save()
  canvas.lineCap = 'round'
  canvas.lineJoin = 'round'
  paintAll(canvas, commands, { families, layer }, canvas.globalAlpha)
  canvas.restore()
}

function paintAll(canvas: Canvas, commands: readonly Command[], tools: Tools, opacity: number): void {
  for (const command of commands) {
    const own = opacity * (command.opacity ?? 1)
    if (command.kind !== 'group') paintShape(canvas, command, tools.families, own)
    else if (tools.layer && isPale(command))
      paintAsOne(canvas, command, { ...tools, layer: tools.layer }, own)
    else paintGroup(canvas, command, tools, own)
  }
}

const isPale = ({ opacity = 1, shapes }: Group) => opacity < 1 && shapes.length > 1

function paintAsOne(
  canvas: Canvas,
  group: Group,
  { families, layer }: Required<Tools>,
  opacity: number,
): void {
  const over = layer!()
  over.setTransform(canvas.getTransform())
  const { opacity: _, ...full } = group
  paint(over, [full], families)
  canvas.save()
  canvas.resetTransform()
  canvas.globalAlpha = opacity
  canvas.drawImage(over.canvas, 0, 0)
  canvas.restore()
}

function paintGroup(canvas: Canvas, group: Group, tools: Tools, opacity: number): void {
  canvas.save()
  canvas.translate(group.x ?? 0, group.y ?? 0)
  if (group.turn) canvas.rotate((group.turn * Math.PI) / 180)
  canvas.scale(...scales(group))
  paintAll(canvas, group.shapes, tools, opacity)
  canvas.restore()
}

type Shape = Exclude<Command, Group>

function paintShape(canvas: Canvas, command: Shape, families: Families, opacity: number): void {
  canvas.globalAlpha = opacity
  if (command.kind === 'text') return write(canvas, command, families)
  if (command.kind === 'path') return ink(canvas, command, pathOf(command.d))
  canvas.beginPath()
  if (command.kind === 'circle')
    canvas.ellipse(command.x, command.y, command.r, command.ry ?? command.r, 0, 0, 2 * Math.PI)
  else if (command.kind === 'rect') outline(canvas, command)
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

function ink(canvas: Canvas, { fill, stroke, lineWidth = 1, dash = solid }: Ink, path?: Path2D): void {
  if (fill !== undefined) {
    canvas.fillStyle = fill
    if (path) canvas.fill(path)
    else canvas.fill()
  }
  if (stroke === undefined) return
  canvas.strokeStyle = stroke
  canvas.lineWidth = lineWidth
  canvas.setLineDash(dash as number[])
  if (path) canvas.stroke(path)
  else canvas.stroke()
}

const alignments = { start: 'left', middle: 'center', end: 'right' } as const

function write(canvas: Canvas, letters: Letters, families: Families): void {
  canvas.font = `${letters.weight ?? 700} ${letters.size}px ${families[letters.font]}`
  canvas.textAlign = alignments[letters.align ?? 'start']
  canvas.fillStyle = letters.fill ?? '#000'
  canvas.fillText(letters.text, letters.x, letters.y)
}
