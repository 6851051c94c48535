import { addBlocks, blockFrom, toolbox, type Template } from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import type { Program } from '@botgarten/programs'

/** A start block, and the block that drives a way with the follower that it holds in the toolbox. */
export function followerProgram(): Program {
  addBlocks(learning, learningToolbox)
  const rows = toolbox.find(({ category }) => category === 'q-learning')!.blocks
  const start: Template = { type: 'robControls_start', mutation: { attrs: { declare: 'false' } } }
  const drive = rows.find(({ type }) => type === 'ai_q_drive_the_best_way')!
  let next = 0
  const blocks = [start, drive].map((row) => blockFrom(row, () => `b${next++}`))
  return { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
}
