import type { Point, Size } from './points.ts'

// What is painted, as data: a canvas paints it on the screen, SVG on paper and in pictures. Lengths are in units of the
// group around it, y down.

/** How a shape is filled and outlined. Corners are round. */
export interface Ink {
  /** Nothing is filled without it. */
  readonly fill?: string
  /** No outline without it. */
  readonly stroke?: string
  /** 1 where nothing is said. */
  readonly lineWidth?: number
  /** Lengths of dashes and gaps in turn. */
  readonly dash?: readonly number[]
  /** The outline ends with its last point, and so do its dashes. Otherwise ends are round. */
  readonly flat?: boolean
  /** Instead of the colour of the outline. */
  readonly stripes?: Stripes
  /** 0 to 1. */
  readonly opacity?: number
}

/** Stripes that rise to the right at 45°, one every so many units. */
export interface Stripes {
  readonly on: string
  readonly colour: string
  readonly every: number
  readonly width: number
}

/** `d` is SVG path data; one that stays the same for many frames is read once. */
type Path = { readonly kind: 'path'; readonly d: string } & Ink

type Line = {
  readonly kind: 'line'
  readonly points: readonly Point[]
  readonly closed?: boolean
} & Ink

/** Many lines at once: x and y of point after point; between two lines stands a point that is not a number. */
export type Lines = { readonly kind: 'lines'; readonly points: Float32Array } & Ink

/** `ry`: the upright half axis of an ellipse. */
type Circle = { readonly kind: 'circle'; readonly r: number; readonly ry?: number } & Point & Ink

/** `x`, `y`: its upper left corner; `round`: radius of its corners. */
export type Rect = {
  readonly kind: 'rect'
  readonly width: number
  readonly height: number
  readonly round?: number
} & Point &
  Ink

/** One line of letters; `x`, `y`: where its base line begins, has its middle or ends. */
export type Letters = {
  readonly kind: 'text'
  readonly text: string
  readonly size: number
  readonly font: Font
  /** 700 where nothing is said. */
  readonly weight?: number
  readonly align?: 'start' | 'middle' | 'end'
} & Point &
  Ink

/** The lab's letters for titles and for reading (`--title`, `--read` of its style). */
export type Font = 'title' | 'read'

/** Moved to `x`, `y`, then turned by `turn` (degrees clockwise), then scaled. */
export type Group = {
  readonly kind: 'group'
  readonly turn?: number
  /** Along x and y, or both alike. */
  readonly scale?: number | readonly [number, number]
  /** 0 to 1. */
  readonly opacity?: number
  /**
   * What it covers, where the same `shapes` are painted again and again: a canvas may keep a picture of them. Without opacity of
   * its own.
   */
  readonly still?: Size & Point
  /** It is seen turned by any angle: the picture is finer than the canvas. */
  readonly turns?: boolean
  /** More is put behind what it has: only that is painted. */
  readonly grows?: boolean
  readonly shapes: readonly Command[]
} & Partial<Point>

export type Command = Path | Line | Lines | Circle | Rect | Letters | Group

/** Along x and y. */
export const scales = ({ scale = 1 }: Group): readonly [number, number] =>
  typeof scale === 'number' ? [scale, scale] : scale

/** The same as SVG path data. */
export const pathOfLines = (points: Float32Array): string =>
  Array.from({ length: points.length / 2 }, (_, i) => {
    const [x, y] = [points[2 * i]!, points[2 * i + 1]!]
    const begins = i === 0 || Number.isNaN(points[2 * i - 2])
    return Number.isNaN(x) ? '' : `${begins ? 'M' : 'L'}${x} ${y}`
  }).join('')
