import * as Blockly from 'blockly/core'
import { grouped } from '../model/list.ts'
import { isStart } from '../model/positions.ts'

type Workspace = Blockly.WorkspaceSvg

/** The type of the block that an element of the pane belongs to, on the workspace or on the open toolbox. */
export function typeAt(workspace: Workspace, element: Element): string | null {
  const id = element.closest('.blocklyDraggable')?.getAttribute('data-id') ?? ''
  const toolbox = workspace.getFlyout()?.getWorkspace()
  const block = workspace.getBlockById(id) ?? toolbox?.getBlockById(id)
  return block?.type ?? null
}

/** One step of the blocks back or forth; false where there is none, or a hand holds a block. */
export function step(workspace: Workspace, redo: boolean): boolean {
  const steps = redo ? workspace.getRedoStack() : workspace.getUndoStack()
  if (steps.length === 0 || workspace.isDragging()) return false
  workspace.hideChaff()
  workspace.undo(redo)
  return true
}

/** Does a hand hold a block, or is a field open? */
export const isInHand = (workspace: Workspace): boolean =>
  workspace.isDragging() || Blockly.WidgetDiv.isVisible() || Blockly.DropDownDiv.isVisible()

/** Changes what lies there: it is no step of undo, and the same part of it stays in sight. */
export function stays(workspace: Workspace, change: () => void): void {
  const { scrollX, scrollY } = workspace
  change()
  workspace.clearUndo()
  workspace.scroll(scrollX, scrollY)
}

export function deleteSelected(): void {
  const selected = Blockly.common.getSelected()
  if (selected instanceof Blockly.BlockSvg && selected.isDeletable()) selected.checkAndDelete()
}

/** A first block that stands further from the corner than this (workspace units) is brought there. */
const near = 40
/** Nor does it touch the toolbox. */
const off = 20
/** Where along one axis what stands at `place` is shown. */
const shownAt = (place: number) => Math.min(near, Math.max(off, place))

/** Px that stay free beside the widest block. */
const beside = 8
/** Blocks are not drawn smaller than this by themselves. */
const leastScale = 0.7

/** Blocks that are wider than the pane are drawn a little smaller, so that all of them is seen. */
export function fitWidth(workspace: Workspace): void {
  const room = workspace.getMetricsManager().getViewMetrics().width - beside
  Blockly.renderManagement.triggerQueuedRenders(workspace)
  const stacks = workspace.getTopBlocks(false)
  const right = (stack: Blockly.BlockSvg) =>
    shownAt(stack.getRelativeToSurfaceXY().x) + stack.getHeightWidth().width
  const widest = Math.max(0, ...stacks.map(right))
  const { scale, scrollX, scrollY } = workspace
  // Blocks that fit exactly are too wide by a rounding error.
  if (widest * scale < room + 1 || room <= 0) return
  workspace.setScale(Math.min(scale, Math.max(leastScale, room / widest)))
  // Blockly moves the blocks by the width of the toolbox as well.
  workspace.scroll(scrollX, (scrollY * workspace.scale) / scale)
}

/**
 * Puts the workspace's corner beside the toolbox; where a file has its start block elsewhere, or without one its first stack,
 * that comes to the corner.
 */
export function place(workspace: Workspace): void {
  fitWidth(workspace)
  const stacks = workspace.getTopBlocks(true)
  const first = stacks.find(isStart) ?? stacks[0]
  const { x, y } = first?.getRelativeToSurfaceXY() ?? { x: 0, y: 0 }
  workspace.scroll((shownAt(x) - x) * workspace.scale, (shownAt(y) - y) * workspace.scale)
}

/** Px at the edges of the pane that its scroll bars take. */
const bars = 12

/** Scrolls as little as it takes to see the first of these parts that fits between the scroll bars, or else the last. */
export function showPart(workspace: Workspace, parts: readonly Blockly.utils.Rect[]): void {
  const around = bars / workspace.scale
  const room = workspace.getMetricsManager().getViewMetrics(true).height - 2 * around
  const part = parts.find(({ top, bottom }) => bottom - top <= room) ?? parts.at(-1)
  if (!part) return
  const { top, bottom, left, right } = part
  workspace.scrollBoundsIntoView(new Blockly.utils.Rect(top, bottom + around, left, right + around), 0)
}

/** Share of the pane's height that no panel lies over. */
const clear = 0.55

/** Brings a block into the part of the pane that no panel lies over; with `focus` the keyboard goes there as well. */
export function reveal(workspace: Workspace, id: string, focus = false): void {
  const block = workspace.getBlockById(id)
  if (!block) return
  const view = workspace.getMetricsManager().getViewMetrics(true)
  const { x, y } = block.getRelativeToSurfaceXY()
  const right = x + Math.min(block.width, view.width / 2)
  const bottom = y + Math.min(block.height, 2 * near)
  const isSeen =
    x >= view.left &&
    right <= view.left + view.width &&
    y >= view.top &&
    bottom <= view.top + view.height * clear
  if (!isSeen) workspace.scroll((near - x) * workspace.scale, (2 * near - y) * workspace.scale)
  if (focus) Blockly.getFocusManager().focusNode(block)
}

/** Several fields of a block, as one step. */
export function setFields(
  workspace: Workspace,
  id: string,
  fields: { readonly [name: string]: string },
): void {
  const block = workspace.getBlockById(id)
  grouped(() => Object.entries(fields).forEach(([name, value]) => block?.setFieldValue(value, name)))
}

/** Does something to the workspace that is no step; what was chosen before is so again. */
export function unseen(workspace: Workspace, change: () => void, after: () => void, focus = true): void {
  const selected = Blockly.common.getSelected()?.id
  workspace.hideChaff()
  Blockly.Events.disable()
  try {
    change()
  } finally {
    Blockly.Events.enable()
  }
  after()
  const block = selected === undefined ? null : workspace.getBlockById(selected)
  if (!block) return
  if (focus) Blockly.getFocusManager().focusNode(block)
  else Blockly.common.setSelected(block)
}
