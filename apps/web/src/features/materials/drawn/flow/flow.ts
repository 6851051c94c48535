import type { Point, Size } from '#drawing/points.ts'
import { m, message } from '#words/message.ts'

/** A box of a flow diagram: its middle and its size, in px. */
interface FlowBox extends Point, Size {}

type FlowSide = 'top' | 'bottom' | 'left' | 'right'

/** The middle of a side of a box. */
const sideOf = ({ x, y, width, height }: FlowBox, side: FlowSide): Point => ({
  x: x + ({ left: -1, right: 1 }[side as string] ?? 0) * (width / 2),
  y: y + ({ top: -1, bottom: 1 }[side as string] ?? 0) * (height / 2),
})

/** How far before the next box a way turns that comes from above and aside. */
const turn = 13

/**
 * The corners of a way from a side of one box to a side of another, its ends included. `lane`: on which x it goes back
 * beside all boxes.
 */
function wayBetween(from: Point, to: Point, lane?: number): readonly Point[] {
  if (lane !== undefined) return [from, { x: lane, y: from.y }, { x: lane, y: to.y }, to]
  if (from.x === to.x || from.y === to.y) return [from, to]
  const y = to.y - turn
  return [from, { x: from.x, y }, { x: to.x, y }, to]
}

/** A way as a path with round corners. */
export function roundedPath(corners: readonly Point[], radius = 9): string {
  const [first, ...rest] = corners
  const parts = rest.map((corner, at) => {
    const next = rest[at + 1]
    if (!next) return `L${corner.x} ${corner.y}`
    const before = towards(corner, corners[at]!, radius)
    const after = towards(corner, next, radius)
    return `L${before.x} ${before.y}Q${corner.x} ${corner.y} ${after.x} ${after.y}`
  })
  return `M${first!.x} ${first!.y}${parts.join('')}`
}

/** Puts an arrow's head, drawn to the right, to the end of a way. */
export function atEnd(corners: readonly Point[]): string {
  const [before, end] = corners.slice(-2) as [Point, Point]
  const turn = (Math.atan2(end.y - before.y, end.x - before.x) * 180) / Math.PI
  return `translate(${end.x} ${end.y}) rotate(${turn})`
}

function towards(from: Point, to: Point, most: number): Point {
  const far = Math.hypot(to.x - from.x, to.y - from.y)
  const share = Math.min(most, far / 2) / far
  return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share }
}

/** A flow diagram as data: what it says are words `materials.flow.<id>`, with a second sentence `…Note` where there is one. */
export interface Flow {
  readonly width: number
  /** From one row to the next, in px. */
  readonly row: number
  readonly boxes: readonly Box[]
  readonly ways: readonly Way[]
}

interface Box {
  readonly id: string
  /** `end`: where everything begins. A question has more than one way out. */
  readonly look: 'end' | 'step' | 'question'
  readonly number?: number
  /** What stands beside it. */
  readonly picture?: 'bo' | 'dice' | 'coin' | 'pencil'
  readonly row: number
  readonly x: number
  readonly width: number
}

/** Goes down, if it does not say on which sides; `lane`: back beside all boxes. */
interface Way {
  readonly from: string
  readonly to: string
  readonly out?: FlowSide
  readonly into?: FlowSide
  readonly lane?: number
  readonly word?: 'yes' | 'no'
  /** What comes at its end. */
  readonly then?: 'nextMove' | 'nextTry'
}

export type LaidBox = Box & FlowBox
export type LaidWay = Way & { readonly corners: readonly Point[] }

const heights = { end: 50, step: 52, question: 56 }

export const heightOf = ({ boxes, row }: Flow): number =>
  Math.max(...boxes.map((box) => box.row)) * row + heights.question + 4

/** Its boxes with their places. */
export const laidOut = ({ boxes, row }: Flow): readonly LaidBox[] =>
  boxes.map((box) => ({ ...box, y: box.row * row + heights.question / 2 + 2, height: heights[box.look] }))

/** Its ways with the corners they turn at, their ends included. */
export function laidWays(flow: Flow): readonly LaidWay[] {
  const boxes = new Map(laidOut(flow).map((box) => [box.id, box]))
  return flow.ways.map((way) => {
    const from = sideOf(boxes.get(way.from)!, way.out ?? 'bottom')
    const to = sideOf(boxes.get(way.to)!, way.into ?? 'top')
    return { ...way, corners: wayBetween(from, to, way.lane) }
  })
}

/** Boxes that say all in one sentence. */
const short: ReadonlySet<string> = new Set(['place'])

export const wordOf = (id: string): string => message(`materials.flow.${id}`)
export const noteOf = (id: string): string | null => (short.has(id) ? null : wordOf(`${id}Note`))

/** Where a question leads, for who does not see its arrows. */
export const wordsAfter = (id: string, ways: Flow['ways']): string =>
  ways
    .flatMap(({ from, to, word }) =>
      from === id && word ? m['materials.flow.goesTo']({ word: wordOf(word), box: wordOf(to) }) : [],
    )
    .join(' ')

/** All that its boxes say, sentence by sentence, in the order of its rows. */
export const flowWords = ({ boxes }: Flow): readonly string[] =>
  boxes.flatMap(({ id }) => [wordOf(id), noteOf(id) ?? []].flat())
