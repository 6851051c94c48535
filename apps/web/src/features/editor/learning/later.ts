import { addBlocks } from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/learning'

/** Makes the blocks for maps and groups known, and puts them on the shelf. */
export const learn = (): void => addBlocks(learning, learningToolbox)
