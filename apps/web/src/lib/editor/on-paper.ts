import * as Blockly from 'blockly/core'
import { grouped } from './list.ts'

type Paper = Blockly.WorkspaceSvg

/** The type of the block that an element of the pane belongs to, on the paper or on the open shelf. */
export function typeAt(paper: Paper, element: Element): string | null {
  const id = element.closest('.blocklyDraggable')?.getAttribute('data-id') ?? ''
  const shelf = paper.getFlyout()?.getWorkspace()
  const block = paper.getBlockById(id) ?? shelf?.getBlockById(id)
  return block?.type ?? null
}

/** One step of the blocks back or forth; false where there is none, or a hand holds a block. */
export function step(paper: Paper, redo: boolean): boolean {
  const steps = redo ? paper.getRedoStack() : paper.getUndoStack()
  if (steps.length === 0 || paper.isDragging()) return false
  paper.hideChaff()
  paper.undo(redo)
  return true
}

export function deleteSelected(): void {
  const selected = Blockly.common.getSelected()
  if (selected instanceof Blockly.BlockSvg && selected.isDeletable()) selected.checkAndDelete()
}

/** A start block that stands further from the corner than this (workspace units) is brought there. */
const near = 40

/** Puts the paper's corner beside the shelf; where a file has its start block further away, that comes to the corner. */
export function place(paper: Paper): void {
  const start = paper.getTopBlocks(false).find(({ type }) => type === 'robControls_start')
  const { x, y } = start?.getRelativeToSurfaceXY() ?? { x: 0, y: 0 }
  paper.scroll(Math.min(0, near - x) * paper.scale, Math.min(0, near - y) * paper.scale)
}

/** Brings a block into sight. */
export function reveal(paper: Paper, id: string): void {
  const block = paper.getBlockById(id)
  if (block) paper.scrollBoundsIntoView(block.getBoundingRectangle())
}

/** Several fields of a block, as one step. */
export function setFields(paper: Paper, id: string, fields: { readonly [name: string]: string }): void {
  const block = paper.getBlockById(id)
  grouped(() => Object.entries(fields).forEach(([name, value]) => block?.setFieldValue(value, name)))
}

/** Does something to the paper that is no step; what was chosen before is so again. */
export function unseen(paper: Paper, change: () => void, after: () => void): void {
  const selected = Blockly.common.getSelected()?.id
  paper.hideChaff()
  Blockly.Events.disable()
  try {
    change()
  } finally {
    Blockly.Events.enable()
  }
  after()
  const block = selected === undefined ? null : paper.getBlockById(selected)
  if (block) Blockly.getFocusManager().focusNode(block)
}
