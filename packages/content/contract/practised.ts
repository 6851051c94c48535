import { practisedAgain } from '../answers/again.ts'
import { content } from '../files.ts'
import type { CardProgram } from '../index.ts'

/** The brain of a card's program after it has practised its own examples again with this seed, from where it began. */
export const practised = (id: string, program: CardProgram, seed: number) =>
  practisedAgain(program, content.card(id)!.world.robots[0]!.config, seed)
