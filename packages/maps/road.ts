import svgpath from 'svgpath'
import type { Element } from './elements.ts'
import { readPath, type PathShape } from './path.ts'
import { distance, type Point } from './point.ts'
import { identity, type Matrix } from './transform.ts'
import type { MapProblem } from './types.ts'

/** Pieces of a road: lines, curves and arcs. */
const MOST_PIECES = 500
/** Characters of its path data. */
const MOST_DATA = 10_000
/** In units of the drawing. */
const FARTHEST = 1e6
/** A move of the pen that is shorter leaves no gap. */
const GAP = 0.01

/** A road as it is drawn, from its first point to its last. */
interface Road extends PathShape {
  /** Path data of `M`, `L`, `A` and `C`, absolute, in units of the map. */
  readonly line: string
}

export type ReadRoad = Road | { readonly problem: MapProblem }

/** Where a road runs: path data of any commands, a line or a polyline, under any transform. */
export function roadIn(name: string, { matrix, unreadTransform, ...element }: Element): ReadRoad {
  const broken = (kind: MapProblem['kind'], facts: MapProblem['facts'] = {}): ReadRoad => ({
    problem: { kind, facts: { name, ...facts } },
  })
  if (unreadTransform !== null) return broken('transform', { value: unreadTransform })
  const data = dataOf(element)
  if (data.length > MOST_DATA) return broken('pathLong', { most: MOST_DATA })
  const plain = matrix.every((value, index) => value === identity[index]) ? readPath(data) : null
  const line = plain ? data : lineOf(data, matrix)
  if (typeof line !== 'string') return broken(line.kind, line.facts)
  const shape = plain ?? readPath(line)
  if (!shape) return broken('pathShape')
  const fits = isNear(shape.from) && isNear(shape.to) && shape.length <= FARTHEST
  return fits ? { ...shape, line } : broken('tooFar')
}

/** Path data of a path, a line or a polyline. */
export function dataOf({ name, attributes }: Pick<Element, 'name' | 'attributes'>): string {
  const at = (...names: string[]) => names.map((one) => attributes[one] ?? '0').join(' ')
  if (name === 'line') return `M${at('x1', 'y1')}L${at('x2', 'y2')}`
  if (name === 'polyline') return `M${attributes['points'] ?? ''}`
  return attributes['d'] ?? ''
}

const isNear = ({ x, y }: Point) => Math.abs(x) <= FARTHEST && Math.abs(y) <= FARTHEST

interface Unread {
  readonly kind: 'pathShape' | 'pathGap' | 'pathPieces' | 'tooFar'
  readonly facts?: MapProblem['facts']
}

/** The same with lines and cubic curves alone, where the transform puts it. */
function lineOf(data: string, matrix: Matrix): string | Unread {
  // Its types leave these two out.
  const path = svgpath(data) as ReturnType<typeof svgpath> & {
    readonly err: string
    readonly segments: unknown[]
  }
  if (path.err !== '') return { kind: 'pathShape' }
  if (path.segments.length > MOST_PIECES) return { kind: 'pathPieces', facts: { most: MOST_PIECES } }
  const strokes: string[] = []
  let at: Point | null = null
  let pen: Point = { x: 0, y: 0 }
  let start = pen
  let broken: 'pathShape' | 'tooFar' | null = null
  path
    .abs()
    .unshort()
    .matrix([...matrix])
    .unarc()
    .iterate(([command, ...values]) => {
      const numbers = values as number[]
      if (command === 'M') return void (start = pen = { x: numbers[0]!, y: numbers[1]! })
      const drawn = drawnBy(command, numbers, pen, start)
      if (!drawn) return void (broken ??= 'pathShape')
      if (![pen, ...drawn].every(isNear)) return void (broken ??= 'tooFar')
      if (at === null || distance(at, pen) > GAP) strokes.push(written('M', pen))
      strokes.push(strokes.pop()! + written(drawn.length === 1 ? 'L' : 'C', ...drawn))
      at = pen = drawn.at(-1)!
    })
  // Some programs draw a road twice, there and there again.
  const [line, ...others] = new Set(strokes)
  if (broken !== null || line === undefined) return { kind: broken ?? 'pathShape' }
  return others.length > 0 ? { kind: 'pathGap' } : line
}

/** The end of a line, or both points that pull a curve and its end; null for what is no drawing. */
function drawnBy(command: string, values: readonly number[], from: Point, start: Point): Point[] | null {
  const points = Array.from({ length: Math.floor(values.length / 2) }, (_, index) => ({
    x: values[2 * index]!,
    y: values[2 * index + 1]!,
  }))
  if (command === 'L' || command === 'C') return points
  if (command === 'H') return [{ x: values[0]!, y: from.y }]
  if (command === 'V') return [{ x: from.x, y: values[0]! }]
  if (command === 'Z' || command === 'z') return [start]
  if (command !== 'Q') return null
  const [pull, to] = points as [Point, Point]
  const towards = (end: Point): Point => ({
    x: end.x + (2 / 3) * (pull.x - end.x),
    y: end.y + (2 / 3) * (pull.y - end.y),
  })
  return [towards(from), towards(to), to]
}

/** To a millionth of a unit: sines of arcs and turns may differ between engines in their last digit. */
const written = (command: string, ...points: readonly Point[]): string =>
  command + points.map(({ x, y }) => `${Number(x.toFixed(6))} ${Number(y.toFixed(6))}`).join(' ')
