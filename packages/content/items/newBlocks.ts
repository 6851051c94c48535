import type { Block } from '@botgarten/blocks'
import type { CardProgram } from '../schema/cardTypes.ts'
import { blocksIn } from './blocksIn.ts'

/** What begins every program, and what is only written into a block. */
const plain: ReadonlySet<string> = new Set([
  'robControls_start',
  'math_number',
  'text',
  'robColour_picker',
  'ai_easy_list',
  'rl_obstacles_easy_list',
])

/** A card's program as the card gives it, and one that does what the card asks for. */
export interface ProgramsOfCard {
  readonly start: CardProgram
  readonly solution: CardProgram
}

/** A block and what is in its sockets. */
const held = (block: Block): readonly Block[] => [block, ...Object.values(block.values ?? {}).flatMap(held)]

/** The kinds of blocks in a card's program, each once, from top to bottom. */
export const kindsOf = (program: CardProgram): readonly string[] => [
  ...new Set(
    blocksIn(program)
      .map(({ type }) => type)
      .filter((type) => !plain.has(type)),
  ),
]

const empty = ({ statements: _between, ...block }: Block): Block => block

/**
 * Blocks of these kinds as they stand in the program that the card gives, and where it gives none of a kind, in its
 * solution. What is in their sockets comes with them and not once more; their arms are empty.
 */
function asTheyStand(types: readonly string[], { start, solution }: ProgramsOfCard): readonly Block[] {
  const given = [...blocksIn(start), ...blocksIn(solution)]
  const first = types.map((type) => given.find((block) => block.type === type)!)
  const inside = new Set(first.flatMap((block) => held(block).slice(1)))
  return first.filter((block) => !inside.has(block)).map(empty)
}

/**
 * The blocks that stand on the front of each card: those of its solution that no card before it has used, drawn from
 * its own programs.
 * @param cards in the order in which they are met
 * @returns blocks by id of a card
 */
export function newBlocks(
  cards: readonly (readonly [card: string, programs: ProgramsOfCard])[],
): Readonly<Record<string, readonly Block[]>> {
  const known = new Set<string>()
  return Object.fromEntries(
    cards.map(([card, programs]) => {
      const fresh = kindsOf(programs.solution).filter((type) => !known.has(type))
      for (const type of fresh) known.add(type)
      return [card, asTheyStand(fresh, programs)]
    }),
  )
}
