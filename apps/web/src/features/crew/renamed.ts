import type { Block } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'

/** The same program with other ids: two programs in one project never share a block. */
export const renamed = (program: Program, idOf: (id: string) => string): Program => ({
  ...program,
  stacks: program.stacks.map((stack) => ({ ...stack, blocks: rows(stack.blocks, idOf) })),
})

const rows = (blocks: readonly Block[], idOf: (id: string) => string): Block[] =>
  blocks.map((block) => renamedBlock(block, idOf))

function renamedBlock(block: Block, idOf: (id: string) => string): Block {
  const { values, statements } = block
  return {
    ...block,
    id: idOf(block.id),
    ...(values && { values: mapped(values, (child) => renamedBlock(child, idOf)) }),
    ...(statements && { statements: mapped(statements, (children) => rows(children, idOf)) }),
  }
}

const mapped = <From, To>(all: { readonly [key: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([key, one]) => [key, change(one)]))
