import { paint, type Picture } from './canvas.ts'
import type { Families } from './shapes.ts'
import { changes } from './changes.ts'
import type { Command, Group } from './commands.ts'
import { Pace } from './pace.ts'
import type { PictureContext } from './picture.ts'
import type { Point, Size } from './points.ts'

/** What lies under the shapes: a picture, or a group that stays the same for many frames. */
export type Layer = Picture | Group

export const isPicture = (layer: Layer): layer is Picture => 'source' in layer

/** What a canvas is to show, and how large and fine it is. */
export interface Frame {
  readonly shapes: readonly Command[]
  /** Under them, from the lowest up. */
  readonly under: readonly Layer[]
  /** In px of the page. */
  readonly size: Size
  /** Where the commands have their 0, in px of the canvas. */
  readonly at: Point
  /** Pixels of the screen per px. */
  readonly ratio: number
  readonly families: Families
}

/** A canvas that paints frame after frame, and of each only what has changed. */
export class Surface {
  readonly #context: PictureContext
  readonly #newLayer: () => PictureContext
  readonly #pace = new Pace()
  #over: PictureContext | null = null
  /** What is on the canvas, and how it came there. */
  #painted: { readonly shapes: readonly Command[]; readonly how: readonly unknown[] } | null = null
  #last: Frame | null = null
  #half = false

  /** @param newLayer another canvas of any size */
  constructor(context: PictureContext, newLayer: () => PictureContext) {
    this.#context = context
    this.#newLayer = newLayer
    // A browser may drop what a canvas holds, and gives it back empty.
    context.canvas.addEventListener('contextrestored', () => this.repaint())
  }

  show(frame: Frame): void {
    const began = performance.now()
    this.#last = frame
    this.#paint(frame)
    if (!this.#half && this.#pace.isSlow(performance.now() - began)) {
      this.#half = true
      this.repaint()
    }
  }

  /** All of it again. */
  repaint(): void {
    this.#painted = null
    if (this.#last) this.#paint(this.#last)
  }

  #paint(frame: Frame): void {
    const { shapes, under, at, families, size } = frame
    const ratio = this.#half ? frame.ratio / 2 : frame.ratio
    const [width, height] = [size.width, size.height].map((side) => Math.max(1, Math.round(side * ratio)))
    const parts = this.#changed(frame, [width, height, ratio, at.x, at.y, families])
    if (parts?.length === 0) return
    const context = this.#context
    resize(context, width!, height!)
    context.resetTransform()
    if (parts) {
      context.save()
      clip(context, parts, at, ratio)
    }
    context.globalAlpha = 1
    context.clearRect(0, 0, width!, height!)
    context.setTransform(ratio, 0, 0, ratio, at.x * ratio, at.y * ratio)
    const layer = () => this.#layer()
    for (const one of under) {
      if (isPicture(one)) context.drawImage(one.source, one.x, one.y, one.width, one.height)
      else paint(context, [one], families, layer)
    }
    context.globalAlpha = 1
    paint(context, shapes, families, layer)
    if (parts) context.restore()
  }

  /** Where it looks different from now on; null: anywhere. */
  #changed({ shapes, under }: Frame, how: readonly unknown[]): readonly (Size & Point)[] | null {
    const goesOn = under.length === 0 && this.#painted?.how.every((one, i) => one === how[i])
    const parts = goesOn ? changes(this.#painted!.shapes, shapes) : null
    this.#painted = { shapes, how }
    return parts
  }

  /** Setting a canvas's size empties it. */
  #layer(): PictureContext {
    this.#over ??= this.#newLayer()
    const { width, height } = this.#context.canvas
    Object.assign(this.#over.canvas, { width, height })
    return this.#over
  }
}

function resize({ canvas }: PictureContext, width: number, height: number) {
  if (canvas.width !== width) canvas.width = width
  if (canvas.height !== height) canvas.height = height
}

/** Nothing outside of these is touched from here on. In whole pixels: an edge that is half in would be painted twice. */
function clip(context: PictureContext, parts: readonly (Size & Point)[], at: Point, ratio: number) {
  context.beginPath()
  for (const part of parts) {
    const [left, top] = [(part.x + at.x) * ratio, (part.y + at.y) * ratio]
    const [x, y] = [Math.floor(left) - 1, Math.floor(top) - 1]
    const right = Math.ceil(left + part.width * ratio) + 1
    const bottom = Math.ceil(top + part.height * ratio) + 1
    context.rect(x, y, right - x, bottom - y)
  }
  context.clip()
}
