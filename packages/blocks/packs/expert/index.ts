// The rest of Open Roberta's two toolboxes, and what only old files hold.
import type { Definition } from '../../types.ts'
import { blocks as core } from '../core/blocks.ts'
import { learning } from '../learning/index.ts'
import { blocks } from './blocks.ts'

export { callBlock, expertToolbox, variableBlocks } from './toolbox.ts'

/** Blocks of the cards with all that Open Roberta's have. */
const completed: readonly Definition[] = Object.values(core).flatMap((block: Definition) =>
  block.expertLook ? [{ ...block, look: { ...block.look, ...block.expertLook } }] : [],
)

/** All that the cards do not need at once, the learning pack included. */
export const expert: { readonly [type: string]: Definition } = {
  ...learning,
  ...blocks,
  ...Object.fromEntries(completed.map((block) => [block.type, block])),
}
