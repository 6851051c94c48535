import { forward, layOut, type Brain, type Weights } from '@botgarten/learning/neural-network'
import { turnOf, turns, type ShownRow, type Turn } from './table.ts'

/** What a network does for two of its inputs, as a square of places. */
export interface Sea {
  readonly cells: number
  /** By place, from the lower left to the right and then up: which way Bo goes, or its strongest output; −1: none is above 0. */
  readonly kinds: Int8Array
}

/** Where wheels are among the outputs. */
type Wheels = { readonly left: number; readonly right: number } | null

/** Of a large network fewer places are asked, so that it is painted in a few milliseconds. */
const cellsFor = (links: number): number => (links > 400 ? 16 : links > 60 ? 28 : 44)

/** What the answer is: an index in `turns` where there are wheels, else in the outputs. */
export function kindOf(outputs: ArrayLike<number>, wheels: Wheels): number {
  if (wheels) return turns.indexOf(turnOf(outputs[wheels.left]!, outputs[wheels.right]!))
  let best = -1
  for (let k = 0; k < outputs.length; k++) if (outputs[k]! > (best < 0 ? 0 : outputs[best]!)) best = k
  return best
}

/** Asks the network all over the first two inputs, 0 to 100; the others are as in `others`. Null: it has fewer than two. */
export function seaOf(brain: Brain, weights: Weights, others: readonly number[], wheels: Wheels): Sea | null {
  const width = brain.layers[0]?.length ?? 0
  if (width < 2) return null
  const links = brain.layers
    .slice(1)
    .reduce((sum, layer, at) => sum + layer.length * brain.layers[at]!.length, 0)
  const cells = cellsFor(links)
  const net = layOut(brain, weights)
  const inputs = Array.from({ length: width }, (_, k) => others[k] ?? 0)
  const kinds = new Int8Array(cells * cells)
  for (let row = 0; row < cells; row++)
    for (let column = 0; column < cells; column++) {
      inputs[0] = (100 * (column + 0.5)) / cells
      inputs[1] = (100 * (row + 0.5)) / cells
      kinds[row * cells + column] = kindOf(forward(net, inputs), wheels)
    }
  return { cells, kinds }
}

export interface Stripe {
  readonly kind: number
  readonly row: number
  readonly column: number
  readonly length: number
}

/** Neighbours in a row that are of one kind, together: there are few of them, and each is painted at once. */
export function stripesOf({ cells, kinds }: Sea): readonly Stripe[] {
  const stripes: Stripe[] = []
  for (let row = 0; row < cells; row++)
    for (let column = 0, end = 0; column < cells; column = end) {
      const kind = kinds[row * cells + column]!
      do end++
      while (end < cells && kinds[row * cells + end] === kind)
      stripes.push({ kind, row, column, length: end - column })
    }
  return stripes
}

/** The mean of each input over the rows; 0 where there are none. */
export function meansOf(rows: readonly ShownRow[], width: number): readonly number[] {
  return Array.from({ length: width }, (_, k) => {
    const values = rows.flatMap(({ inputs }) => inputs[k] ?? [])
    return values.length === 0 ? 0 : values.reduce((sum, value) => sum + value, 0) / values.length
  })
}

/** More dots hide each other. */
const mostDots = 300

export interface Dot {
  readonly at: number
  readonly number: number
  /** 0 to 100. */
  readonly x: number
  readonly y: number
  readonly kind: number
}

/** The rows as dots in the colour of their wish: a wrong one is seen in the wrong sea. */
export const dotsOf = (rows: readonly ShownRow[], wheels: Wheels): readonly Dot[] =>
  rows.slice(-mostDots).flatMap(({ at, number, inputs, outputs }) => {
    const [x, y] = inputs
    if (x == null || y == null || outputs.includes(null)) return []
    return [{ at, number, x, y, kind: kindOf(outputs as readonly number[], wheels) }]
  })

export const turnAt = (kind: number): Turn => turns[kind] ?? 'stand'
