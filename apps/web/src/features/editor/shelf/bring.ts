import type { WorkspaceSvg } from 'blockly/core'
import { fetchHelp, withWords } from '#words/say.ts'

/** What a child looks a block up with, and what blocks do. */
export const bringSearch = (lost?: () => void) =>
  withWords(
    Promise.all([import('./later.ts'), fetchHelp()]).then(([search]) => search),
    lost,
  )

/** Tells what blocks of a type do, with an example that can be put on the paper. */
export const explain = async (paper: WorkspaceSvg, type: string): Promise<void> =>
  (await bringSearch()).explain(paper, type)
