import type { Block } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'

/** Every block of a program, those inside others too. */
export function blocksOf({ stacks }: Program): readonly Block[] {
  const inside = (block: Block): readonly Block[] => [
    block,
    ...Object.values(block.values ?? {}).flatMap(inside),
    ...Object.values(block.statements ?? {}).flatMap((row) => row.flatMap(inside)),
  ]
  return stacks.flatMap(({ blocks }) => blocks.flatMap(inside))
}

/** The program with each block replaced: by zero or more blocks in a row. */
export function mapped(program: Program, change: (block: Block) => readonly Block[]): Program {
  const row = (blocks: readonly Block[]): Block[] => blocks.flatMap((block) => change(inside(block)))
  const inside = (block: Block): Block => ({
    ...block,
    ...(block.values && {
      values: Object.fromEntries(
        Object.entries(block.values).flatMap(([name, child]) =>
          change(inside(child))
            .slice(0, 1)
            .map((one) => [name, one]),
        ),
      ),
    }),
    ...(block.statements && {
      statements: Object.fromEntries(
        Object.entries(block.statements).map(([name, blocks]) => [name, row(blocks)]),
      ),
    }),
  })
  const stacks = program.stacks.map((stack) => ({ ...stack, blocks: row(stack.blocks) }))
  return { ...program, stacks: stacks.filter(({ blocks }) => blocks.length > 0) }
}

export const withFields = (
  program: Program,
  id: string,
  fields: { readonly [name: string]: string },
): Program =>
  mapped(program, (block) => [block.id === id ? { ...block, fields: { ...block.fields, ...fields } } : block])

/** The map block with these roads closed. */
export function withRoads(
  program: Program,
  map: string,
  roads: readonly (readonly [number, number])[],
): Program {
  const list: Block = {
    id: 'closed',
    type: 'rl_obstacles_easy_list',
    mutation: { attrs: { items: String(roads.length), list_type: 'Obstacle' } },
    values: Object.fromEntries(
      roads.map(([from, to], at) => [
        `ADD${at}`,
        { id: `road${at}`, type: 'ai_q_barrier_mountain', fields: { FROM: String(from), TO: String(to) } },
      ]),
    ),
  }
  const { OBSTACLE: _, ...others } = blocksOf(program).find(({ id }) => id === map)?.values ?? {}
  const values = roads.length > 0 ? { ...others, OBSTACLE: list } : others
  return mapped(program, (block) => [block.id === map ? { ...block, values } : block])
}

/** The block under other ids, as Blockly does when it copies. */
export function copyOf(block: Block, suffix: string): Block {
  const { values, statements } = block
  return {
    ...block,
    id: block.id + suffix,
    ...(values && {
      values: Object.fromEntries(Object.entries(values).map(([name, one]) => [name, copyOf(one, suffix)])),
    }),
    ...(statements && {
      statements: Object.fromEntries(
        Object.entries(statements).map(([name, row]) => [name, row.map((one) => copyOf(one, suffix))]),
      ),
    }),
  }
}
