import * as Blockly from 'blockly/core'
import { partedTops } from '#drawing/parted.ts'
import { grouped } from './list.ts'

interface Point {
  readonly x: number
  readonly y: number
}

/** A stack that is shown elsewhere than its file has it. */
interface Parted {
  readonly own: Point
  readonly shown: Point
}

/** By the id of a stack's first block. Nothing of it is in the program: who moves the stack decides where it is. */
const parted = new WeakMap<Blockly.Workspace, ReadonlyMap<string, Parted>>()

/** Between stacks that had to be parted, in workspace units. */
const gap = 24
/** Undoing a move adds and subtracts the same fractions. */
const same = (a: Point, b: Point) => Math.abs(a.x - b.x) + Math.abs(a.y - b.y) < 0.01

export const shownPosition = (block: Blockly.Block): Point => {
  const { x, y } = block.getRelativeToSurfaceXY()
  return { x, y }
}

/** Where a stack belongs: for one that was only parted from others, where its file has it. */
export function positionOf(block: Blockly.Block): Point {
  const shown = shownPosition(block)
  const moved = parted.get(block.workspace)?.get(block.id)
  return moved && same(moved.shown, shown) ? moved.own : shown
}

export const isStart = ({ type }: Blockly.Block): boolean => type === 'robControls_start'

/** The start block's stack first, then as they are read. */
const inOrder = (workspace: Blockly.WorkspaceSvg): readonly Blockly.BlockSvg[] =>
  workspace
    .getTopBlocks(false)
    .filter((block) => !block.isInsertionMarker())
    .map((block) => ({ block, ...shownPosition(block) }))
    .sort((a, b) => Number(isStart(b.block)) - Number(isStart(a.block)) || a.y - b.y || a.x - b.x)
    .map(({ block }) => block)

function boxOf(block: Blockly.BlockSvg) {
  const { left, top, right, bottom } = block.getBoundingRectangle()
  return { left, top, width: right - left, height: bottom - top }
}

/** What was parted on this workspace before is of another program. */
export const forgetParted = (workspace: Blockly.Workspace): void => void parted.delete(workspace)

/**
 * Moves stacks that lie on each other apart, without a step that could be undone: blocks are taller here than where the
 * file was made. The start block's stack stays.
 */
export function part(workspace: Blockly.WorkspaceSvg): void {
  const stacks = inOrder(workspace)
  const tops = partedTops(stacks.map(boxOf), gap)
  const after = new Map<string, Parted>()
  Blockly.Events.disable()
  stacks.forEach((block, at) => {
    const own = positionOf(block)
    const down = tops[at]! - boxOf(block).top
    if (down > 0) block.moveBy(0, down)
    const shown = shownPosition(block)
    if (!same(own, shown)) after.set(block.id, { own, shown })
  })
  Blockly.Events.enable()
  parted.set(workspace, after)
  workspace.resizeContents()
}

/** Puts all stacks below the start block's, or else below the first, as one step to undo. */
export function tidy(workspace: Blockly.WorkspaceSvg): void {
  const [first, ...others] = inOrder(workspace)
  if (!first) return
  const { left, top, height } = boxOf(first)
  let next = Math.ceil(top + height + gap)
  grouped(() => {
    for (const block of others) {
      const box = boxOf(block)
      block.moveBy(left - box.left, next - box.top, ['cleanup'])
      next += Math.ceil(box.height + gap)
    }
  })
}
