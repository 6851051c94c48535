import type { Block } from '@botgarten/blocks'
import type { CardProgram } from '../schema/cardTypes.ts'

/** A block, what is in its sockets, and what stands between its arms. */
const within = (block: Block): readonly Block[] => [
  block,
  ...[...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()].flatMap(within),
]

/** All blocks of a program, from top to bottom. */
export const blocksIn = ({ programs }: CardProgram): readonly Block[] =>
  Object.values(programs).flatMap(({ stacks }) => stacks.flatMap(({ blocks }) => blocks.flatMap(within)))
