import * as Blockly from 'blockly/core'
import { isBotBlock, type BotBlock } from '../model/bot-block.ts'
import { closeLine, foot, linesOf, openLine } from '../model/list.ts'

interface Left {
  readonly list: string
  readonly line: string
  readonly group: string
}

/**
 * Lists follow what a hand does with their neurons, within the same step of undo: one that is dropped on the foot gets
 * a line of its own, and the line that one was taken from closes when the hand lets go. `isHeld`: does it hold a block?
 */
export function followNeurons(
  workspace: Blockly.Workspace,
  isHeld: () => boolean,
): (event: Blockly.Events.Abstract) => void {
  let left: readonly Left[] = []

  return (event) => {
    if (event instanceof Blockly.Events.BlockMove && event.recordUndo) {
      settleAtFoot(event, workspace)
      left = [...left, ...lineLeftBy(event, workspace)]
    }
    if (left.length === 0 || isHeld()) return
    const closing = left
    left = []
    for (const { list, line, group } of closing) {
      const block = workspace.getBlockById(list)
      if (isBotBlock(block) && linesOf(block).includes(line)) inGroup(group, () => closeLine(block, line))
    }
  }
}

function settleAtFoot(event: Blockly.Events.BlockMove, workspace: Blockly.Workspace) {
  const list = listOf(event.newParentId, workspace)
  const neuron = list && event.newInputName === foot ? list.getInputTargetBlock(foot) : null
  if (!list || !neuron?.outputConnection) return
  const { outputConnection } = neuron
  inGroup(event.group, () => {
    const line = openLine(list)
    const socket = line === null ? null : list.getInput(line)?.connection
    if (socket) socket.connect(outputConnection)
    else outputConnection.disconnect()
  })
}

function lineLeftBy(event: Blockly.Events.BlockMove, workspace: Blockly.Workspace): readonly Left[] {
  const list = listOf(event.oldParentId, workspace)
  const line = event.oldInputName
  if (!list || line === undefined || !linesOf(list).includes(line)) return []
  return [{ list: list.id, line, group: event.group }]
}

function listOf(id: string | undefined, workspace: Blockly.Workspace): BotBlock | null {
  const block = id === undefined ? null : workspace.getBlockById(id)
  return isBotBlock(block) && block.definition.look.items ? block : null
}

function inGroup(group: string, change: () => void) {
  const outer = Blockly.Events.getGroup()
  Blockly.Events.setGroup(group)
  try {
    change()
  } finally {
    Blockly.Events.setGroup(outer)
  }
}
