import { editor } from '#features/editor/feature.ts'
import { fillBlocks } from '#figures/blocks/slot.ts'

fillBlocks(editor.load)
