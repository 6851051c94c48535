import { editor } from '#features/editor/feature.ts'
import { teacher } from '#features/teacher/feature.ts'
import { fillBlocks } from '#figures/blocks/slot.ts'
import { fetchWords } from '#words/message.ts'

// A teacher who looks inside sees the blocks as the editor draws them.
fillBlocks(editor.load)

export const load = () => fetchWords(...teacher.words)
