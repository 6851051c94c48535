import { sideOf, wayBetween, type FlowBox, type FlowSide } from '#drawing/flow.ts'
import type { Point } from '#drawing/points.ts'

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
  readonly picture?: 'bo' | 'dice' | 'star' | 'pencil'
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

type Laid = Box & FlowBox

const heights = { end: 50, step: 52, question: 56 }

export const heightOf = ({ boxes, row }: Flow): number =>
  Math.max(...boxes.map((box) => box.row)) * row + heights.question + 4

/** Its boxes with their places. */
export const laidOut = ({ boxes, row }: Flow): readonly Laid[] =>
  boxes.map((box) => ({ ...box, y: box.row * row + heights.question / 2 + 2, height: heights[box.look] }))

/** Its ways with the corners they turn at, their ends included. */
export function laidWays(flow: Flow): readonly (Way & { readonly corners: readonly Point[] })[] {
  const boxes = new Map(laidOut(flow).map((box) => [box.id, box]))
  return flow.ways.map((way) => {
    const from = sideOf(boxes.get(way.from)!, way.out ?? 'bottom')
    const to = sideOf(boxes.get(way.to)!, way.into ?? 'top')
    return { ...way, corners: wayBetween(from, to, way.lane) }
  })
}
