import * as Blockly from 'blockly/core'
import type { Template } from '@botgarten/blocks'
import { stateOfTemplate } from '../../model/state.ts'

/** A hand that moves less far only chooses. */
const far = 6
/** Where the hand holds the block, from its upper left corner. */
const hold = { x: 18, y: 12 }
const room = 200

/** A hit that is pulled out of the list becomes a block in the hand, as if it had come from the toolbox. `begin` is called then. */
export function letPull(
  { button, pointerId, pointerType, clientX, clientY }: PointerEvent,
  workspace: Blockly.WorkspaceSvg,
  template: Template,
  begin: () => void,
): void {
  if (button !== 0) return
  const away = new AbortController()
  const { signal } = away
  const move = (to: PointerEvent) => {
    const [aside, along] = [Math.abs(to.clientX - clientX), Math.abs(to.clientY - clientY)]
    if (to.pointerId !== pointerId || Math.hypot(aside, along) < far) return
    away.abort()
    // A finger that goes up or down scrolls the list.
    if (pointerType === 'touch' && along > aside) return
    begin()
    pull(workspace, template, to)
  }
  addEventListener('pointermove', move, { signal })
  for (const end of ['pointerup', 'pointercancel']) addEventListener(end, () => away.abort(), { signal })
}

/** Makes the block under the hand, in one step of undo with where it goes, and lets Blockly take it from there. */
function pull(workspace: Blockly.WorkspaceSvg, template: Template, hand: PointerEvent) {
  const { clientX, clientY, pointerId, pointerType } = hand
  const { Coordinate } = Blockly.utils
  const at = Blockly.utils.svgMath.screenToWsCoordinates(workspace, new Coordinate(clientX, clientY))
  // Blockly pushes away what lies where a block is made: it is made below all others.
  const state = { ...stateOfTemplate(template), y: workspace.getBlocksBoundingBox().bottom + room }
  Blockly.Events.setGroup(true)
  const block = Blockly.serialization.blocks.append(state, workspace, {
    recordUndo: true,
  }) as Blockly.BlockSvg
  block.moveTo(new Coordinate(at.x - hold.x, at.y - hold.y))
  const down = { clientX, clientY, pointerId, pointerType, button: 0, buttons: 1, isPrimary: true }
  block.pathObject.svgPath.dispatchEvent(new PointerEvent('pointerdown', { ...down, bubbles: true }))
}
