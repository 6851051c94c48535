import type { Block } from '@botgarten/blocks'
import type { CardProgram } from '../schema/cardTypes.ts'
import { blocksIn } from './blocksIn.ts'

/** What is shown of a program, by ids of its blocks; without both: all of it. */
export interface Part {
  /** This block with what is in it, and nothing else. */
  readonly only?: string | undefined
  /** This block is folded to one line. */
  readonly fold?: string | undefined
}

type Rows = CardProgram['programs'][string]['stacks']

/** @throws Error where the program has no such block: a mistake in the content */
export function partOf(program: CardProgram, { only, fold }: Part): CardProgram {
  for (const id of [only, fold])
    if (id !== undefined && !blocksIn(program).some((block) => block.id === id))
      throw new Error(`There is no block "${id}".`)
  const chosen = only === undefined ? program : withRows(program, () => alone(program, only))
  return fold === undefined
    ? chosen
    : withRows(chosen, (rows) =>
        rows.map((row) => ({ ...row, blocks: row.blocks.map((block) => folded(block, fold)) })),
      )
}

const withRows = (program: CardProgram, change: (rows: Rows) => Rows): CardProgram => ({
  ...program,
  programs: mapped(program.programs, (one) => ({ ...one, stacks: change(one.stacks) })),
})

const alone = (program: CardProgram, id: string): Rows => [
  { x: 0, y: 0, blocks: blocksIn(program).filter((block) => block.id === id) },
]

const folded = (block: Block, id: string): Block => ({
  ...block,
  ...(block.id === id && { collapsed: true }),
  ...(block.values && { values: mapped(block.values, (inside) => folded(inside, id)) }),
  ...(block.statements && {
    statements: mapped(block.statements, (row) => row.map((inside) => folded(inside, id))),
  }),
})

const mapped = <From, To>(all: { readonly [name: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([name, one]) => [name, change(one)]))
