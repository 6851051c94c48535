import type { Block } from '@botgarten/blocks'

/** Blocks that are plugged into a block, or stand in it. */
export const childrenOf = ({ values, statements }: Block): readonly Block[] => [
  ...Object.values(values ?? {}),
  ...Object.values(statements ?? {}).flat(),
]

/** How many blocks it is with all in it; those that are switched off do not count. */
export const sizeOf = (block: Block): number =>
  block.disabled ? 0 : childrenOf(block).reduce((sum, child) => sum + sizeOf(child), 1)

/** Does this hold for a block, or for one in it, that is not switched off? */
export const someIn = (block: Block, holds: (block: Block) => boolean): boolean =>
  !block.disabled && (holds(block) || childrenOf(block).some((child) => someIn(child, holds)))
