import * as Blockly from 'blockly/core'
import { isBotBlock } from './bot-block.ts'

export interface Copy {
  readonly from: string
  readonly to: string
}

/** Watches for neurons that arrive as copies of others: their weights want to be copied too. */
export function watchCopies(
  workspace: Blockly.Workspace,
): (event: Blockly.Events.Abstract) => readonly Copy[] {
  // A block from the toolbox is a copy too, of one that never stood on the workspace.
  const gone = new Set<string>()
  const wasHere = (id: string) => gone.has(id) || workspace.getBlockById(id) !== null

  return (event) => {
    if (event instanceof Blockly.Events.BlockDelete) for (const id of event.ids ?? []) gone.add(id)
    if (!(event instanceof Blockly.Events.BlockCreate) || !event.recordUndo) return []
    return (event.ids ?? []).flatMap((to) => {
      const block = workspace.getBlockById(to)
      const from = isBotBlock(block) ? block.copyOf : null
      return from !== null && wasHere(from) ? [{ from, to }] : []
    })
  }
}
