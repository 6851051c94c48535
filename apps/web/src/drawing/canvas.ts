import { scales, type Command, type Group } from './commands.ts'
import { beginsWith } from './prefix.ts'
import { pictureOf, type PictureContext } from './picture.ts'
import type { Point, Size } from './points.ts'
import { paintShape, type Canvas, type Families } from './shapes.ts'

/** Another canvas as large as the one that is painted on, and empty. */
export type Layer = () => PictureContext

/** A picture of what seldom changes, and where it lies; in px. */
export interface Picture extends Point, Size {
  readonly source: CanvasImageSource
}

/** What paints, and with what. */
interface Tools {
  readonly families: Families
  readonly layer: Layer | undefined
}

/** As `setTransform` takes it. */
type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number]

/**
 * Paints commands one after the other, onto what is there. Leaves the canvas moved, turned and scaled as it found it; letters
 * and inks are the last ones, since to set the same letters again costs nothing, and to restore others much.
 * @param layer a group that is pale is painted there first, so that it is pale as one; without it each shape is
 */
export function paint(canvas: Canvas, commands: readonly Command[], families: Families, layer?: Layer): void {
  const { a, b, c, d, e, f } = canvas.getTransform()
  canvas.lineJoin = 'round'
  paintAll(canvas, commands, { families, layer }, [a, b, c, d, e, f], 1)
}

function paintAll(
  canvas: Canvas,
  commands: readonly Command[],
  tools: Tools,
  at: Matrix,
  opacity: number,
): void {
  for (const command of commands) {
    const own = opacity * (command.opacity ?? 1)
    if (command.kind !== 'group') paintShape(canvas, command, tools.families, own)
    else if (tools.layer && isPale(command))
      paintAsOne(canvas, command, { ...tools, layer: tools.layer }, at, own)
    else paintGroup(canvas, command, tools, at, own)
  }
}

const isPale = ({ opacity = 1, shapes }: Group) => opacity < 1 && shapes.length > 1

function paintAsOne(
  canvas: Canvas,
  group: Group,
  { families, layer }: Required<Tools>,
  at: Matrix,
  opacity: number,
): void {
  const over = layer!()
  over.setTransform(...at)
  const { opacity: _, ...full } = group
  paint(over, [full], families)
  canvas.resetTransform()
  canvas.globalAlpha = opacity
  canvas.drawImage(over.canvas, 0, 0)
  canvas.setTransform(...at)
}

function paintGroup(canvas: Canvas, group: Group, tools: Tools, at: Matrix, opacity: number): void {
  const own = within(at, group)
  // The browser's own arithmetic makes an object each time it is asked where it is.
  canvas.setTransform(...own)
  if (group.still && tools.layer) paintStill(canvas, group, group.still, tools.families, own, opacity)
  else paintAll(canvas, group.shapes, tools, own, opacity)
  canvas.setTransform(...at)
}

/** Where the shapes of a group are, in a group that is there. */
function within([a, b, c, d, e, f]: Matrix, group: Group): Matrix {
  const { x = 0, y = 0, turn = 0 } = group
  const [sx, sy] = scales(group)
  const [cos, sin] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)]
  return [
    (a * cos + c * sin) * sx,
    (b * cos + d * sin) * sx,
    (c * cos - a * sin) * sy,
    (d * cos - b * sin) * sy,
    a * x + c * y + e,
    b * x + d * y + f,
  ]
}

/** So much finer than the canvas is what turns. */
const finer = 1.5
interface Still {
  readonly scale: number
  /** Letters that come later are other ones. */
  readonly families: Families
  readonly bounds: Size & Point
  readonly shapes: readonly Command[]
  readonly picture: ReturnType<typeof pictureOf>
}
const stills = new WeakMap<readonly Command[], Still>()
/** The last picture of a group that grows, by its first shape. */
const grown = new WeakMap<Command, Still>()

function paintStill(
  canvas: Canvas,
  group: Group,
  bounds: Size & Point,
  families: Families,
  [a, b]: Matrix,
  opacity: number,
): void {
  const scale = Math.hypot(a, b) * (group.turns ? finer : 1)
  const picture = pictureOfStill(group, bounds, scale, families)
  canvas.globalAlpha = opacity
  // Its own size in whole pixels: what does not turn stays as sharp as it was painted.
  canvas.drawImage(picture, bounds.x, bounds.y, picture.width / scale, picture.height / scale)
}

function pictureOfStill(
  { shapes, grows }: Group,
  bounds: Size & Point,
  scale: number,
  families: Families,
): Still['picture'] {
  const look = { scale, families, bounds }
  const known = stills.get(shapes)
  if (known && isAlike(known, look)) return known.picture
  const before = grows && shapes[0] ? grown.get(shapes[0]) : undefined
  const still = { ...look, shapes, picture: stillOf(shapes, look, goesOn(before, shapes, look)) }
  stills.set(shapes, still)
  if (grows && shapes[0]) grown.set(shapes[0], still)
  return still.picture
}

/** These shapes are not painted again: their picture need not wait until somebody tidies up. */
export function forget(shapes: readonly Command[]): void {
  const still = stills.get(shapes)
  if (!still) return
  stills.delete(shapes)
  const [first] = shapes
  if (first && grown.get(first) === still) grown.delete(first)
  if ('close' in still.picture) still.picture.close()
}

type Look = Pick<Still, 'scale' | 'families' | 'bounds'>

const isAlike = (a: Look, b: Look) =>
  a.scale === b.scale &&
  a.families === b.families &&
  a.bounds.x === b.bounds.x &&
  a.bounds.y === b.bounds.y &&
  a.bounds.width === b.bounds.width &&
  a.bounds.height === b.bounds.height

/** What is in the picture before, if the shapes are those of then and some more. */
const goesOn = (before: Still | undefined, shapes: readonly Command[], look: Look): Still | undefined =>
  before && isAlike(before, look) && beginsWith(shapes, before.shapes) ? before : undefined

function stillOf(
  shapes: readonly Command[],
  { bounds: { x, y, width, height }, scale, families }: Look,
  before: Still | undefined,
): Still['picture'] {
  const whole = (length: number) => Math.max(1, Math.ceil(length * scale))
  return pictureOf(whole(width), whole(height), (context) => {
    if (before) context.drawImage(before.picture, 0, 0)
    context.setTransform(scale, 0, 0, scale, -x * scale, -y * scale)
    paint(context, before ? shapes.slice(before.shapes.length) : shapes, families)
  })
}
