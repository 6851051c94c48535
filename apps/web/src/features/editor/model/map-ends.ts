import * as Blockly from 'blockly/core'
import { mapEnds } from '@botgarten/blocks'

const mapBlock = 'ai_q_learning_states_and_actions_map'

/**
 * Start and goal of a map block follow when another map is chosen in it, as part of the same step of undo: stations of the
 * map before mean nothing on the new one.
 */
export function followMap(workspace: Blockly.Workspace): (event: Blockly.Events.Abstract) => void {
  return (event) => {
    if (!(event instanceof Blockly.Events.BlockChange) || !event.recordUndo) return
    if (event.element !== 'field' || event.name !== 'MAP') return
    const block = workspace.getBlockById(event.blockId ?? '')
    const ends = mapEnds(String(event.newValue))
    if (block?.type !== mapBlock || !ends) return
    const outer = Blockly.Events.getGroup()
    Blockly.Events.setGroup(event.group)
    for (const [index, name] of ['START', 'FINISH'].entries()) block.setFieldValue(ends[index], name)
    Blockly.Events.setGroup(outer)
  }
}
