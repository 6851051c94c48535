import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { createLab } from '@botgarten/lab'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { content } from '../files.ts'
import { cardDocument } from '../index.ts'
import type { Claim } from '../schema/planTypes.ts'

addBlocks(learning)

/** The second in which all checks of a card have passed; null: a minute, or what the claim says, is not enough. */
export function secondOf({ card: id, weights, place, passed }: Claim): number | null {
  const { card, world } = content.card(id)!
  const program = content.program(id, 'solution')!
  const brains = Object.fromEntries(
    Object.entries(program.brains).map(([name, brain]) => [name, { ...brain, weights }]),
  )
  const lab = createLab()
  const document = cardDocument(world, card, { ...program, brains }, place - 1)
  lab.load(document, content.floorOf(world), { seed: 1, checks: card.checks })
  lab.start()
  for (let second = 1; second <= Math.max(60, (passed ?? 0) + 1); second++) {
    lab.advance(TICKS_PER_SECOND)
    if (lab.view().checks.every((check) => check.passed)) return second
  }
  return null
}
