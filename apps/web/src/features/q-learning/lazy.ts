import type { LabUi } from '#lab/ui.svelte.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import type { Blocks } from './model/block-edits.ts'
import { Learning } from './model/learning.svelte.ts'
import { pinnedSeed } from './model/dice.ts'
import Folded from './view/Folded.svelte'
import QPlayground from './view/QPlayground.svelte'

/** A session that learns, with what shows it. */
export interface Learner {
  readonly QPlayground: typeof QPlayground
  readonly Folded: typeof Folded
  readonly learning: Learning
}

/**
 * Opens the playground of a session.
 * @param show is given it, and null when it is closed
 * @returns how to close it
 */
export function hold(
  session: LabSession,
  ui: LabUi,
  blocks: Blocks,
  show: (learner: Learner | null) => void,
): () => void {
  const learning = new Learning(session, ui, blocks, pinnedSeed(location.search))
  const close = learning.open()
  show({ QPlayground, Folded, learning })
  return () => {
    close()
    show(null)
  }
}
