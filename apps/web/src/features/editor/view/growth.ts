import * as Blockly from 'blockly/core'
import { fitWidth, showPart } from './on-workspace.ts'

/**
 * A block that has grown by its plus, or had a neuron added to it from outside, stays in sight: as wide as the pane allows, with
 * the plus and all that stands below it in the same statement, so that a hand can go on pressing there.
 */
export function followGrowth(workspace: Blockly.WorkspaceSvg): (event: Blockly.Events.Abstract) => void {
  return (event) => {
    if (!(event instanceof Blockly.Events.BlockChange) || !event.recordUndo || !hasGrown(event)) return
    const block = workspace.getBlockById(event.blockId ?? '')
    if (!block) return
    void Blockly.renderManagement.finishQueuedRenders().then(() => {
      if (block.isDeadOrDying() || workspace.isDragging()) return
      if (!isZoomed(workspace)) fitWidth(workspace)
      showPart(workspace, grownPart(block))
    })
  }
}

/** A child that has asked for larger blocks keeps them. */
const isZoomed = ({ scale, options }: Blockly.WorkspaceSvg) => scale > options.zoomOptions.startScale

/** The state that a plus changes gets longer with every line. */
const hasGrown = ({ element, oldValue, newValue }: Blockly.Events.BlockChange) =>
  element === 'mutation' && String(newValue).length > String(oldValue).length

/** px at scale 1. The line above the plus is new. */
const line = 50

/** Most urgent first: the new line with the plus, then all down to the end of the statement. */
function grownPart(block: Blockly.BlockSvg): readonly Blockly.utils.Rect[] {
  const plus = block.getField('PLUS')
  const { top, bottom, left } = block.getBoundingRectangleWithoutChildren()
  const at = plus?.isVisible() ? offsetOf(plus) : { x: 0, y: bottom - top - line }
  const size = plus?.getSize() ?? { width: line, height: line }
  const start = Math.max(top, top + at.y - line)
  const right = left + at.x + size.width
  const end = statementOf(block).getBoundingRectangleWithoutChildren().bottom
  return [
    new Blockly.utils.Rect(start, end, left, right),
    new Blockly.utils.Rect(start, top + at.y + size.height, left, right),
  ]
}

/** Of a field, from its block's corner. */
const offsetOf = (field: Blockly.Field) => Blockly.utils.svgMath.getRelativeXY(field.getSvgRoot()!)

/** The block that stands in a row of blocks, however deep this one is plugged into it. */
function statementOf(block: Blockly.BlockSvg): Blockly.BlockSvg {
  let at = block
  for (let next = at.getParent(); at.outputConnection && next; next = at.getParent()) at = next
  return at
}
