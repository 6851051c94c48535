import type { WorkspaceSvg } from 'blockly/core'
import { withWords } from '#words/say.ts'

/** What a child looks a block up with, and what blocks do. */
export const bringSearch = (lost?: () => void) => withWords(import('./later.ts'), ['editor', 'help'], lost)

/** Tells what blocks of a type do, with an example that can be put on the paper. */
export const explain = async (paper: WorkspaceSvg, type: string): Promise<void> =>
  (await bringSearch()).explain(paper, type)
