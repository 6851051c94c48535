import * as Blockly from 'blockly/core'
import type { Template } from '@botgarten/blocks'
import { grouped } from '../../model/list.ts'
import { stateOfTemplate } from '../../model/state.ts'

/** The block that a hand or the keyboard was at last. */
function anchorOn(paper: Blockly.WorkspaceSvg): Blockly.BlockSvg | null {
  const node = Blockly.FocusableTreeTraverser.findFocusedNode(paper)
  return node ? paper.getNavigator().getSourceBlockFromNode(node) : null
}

/** Puts a block of the shelf at the one that was chosen last, where it fits; else below all others. Returns it. */
export function put(paper: Blockly.WorkspaceSvg, template: Template): Blockly.BlockSvg {
  return grouped(() => {
    const anchor = anchorOn(paper)
    const box = paper.getBlocksBoundingBox()
    const state = { ...stateOfTemplate(template), x: box.left, y: box.bottom + 24 }
    const block = Blockly.serialization.blocks.append(state, paper, { recordUndo: true }) as Blockly.BlockSvg
    if (anchor) join(block, anchor)
    void show(paper, block)
    return block
  })
}

/** Chosen, and where it can be seen. */
export async function show(paper: Blockly.WorkspaceSvg, block: Blockly.BlockSvg) {
  await Blockly.renderManagement.finishQueuedRenders()
  Blockly.getFocusManager().focusNode(block)
  paper.scrollBoundsIntoView(block.getBoundingRectangle(), 24)
}

function join(block: Blockly.BlockSvg, anchor: Blockly.BlockSvg): void {
  if (block.outputConnection) return void gapFor(block, anchor)?.connect(block.outputConnection)
  for (let at: Blockly.BlockSvg | null = anchor; at && block.previousConnection; at = at.getSurroundParent())
    if (at.nextConnection && goes(block.previousConnection, at.nextConnection))
      return void at.nextConnection.connect(block.previousConnection)
}

/** The first gap of a block, or of those around it, that takes this value. */
function gapFor(block: Blockly.BlockSvg, anchor: Blockly.BlockSvg): Blockly.Connection | null {
  const inputs = anchor.inputList.filter(({ type }) => type === Blockly.inputs.inputTypes.VALUE)
  for (const { connection } of inputs) {
    const there = connection?.targetBlock()
    if (connection && (!there || there.isShadow()) && goes(block.outputConnection, connection))
      return connection
  }
  const around = anchor.getParent()
  return around && anchor.outputConnection ? gapFor(block, around) : null
}

const goes = (block: Blockly.Connection | null, there: Blockly.Connection): boolean =>
  there.getConnectionChecker().canConnect(there, block, false)
