import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { createLab, type Lab } from '@botgarten/lab'
import { sample } from '@botgarten/numbers/testing'
import { TICKS_PER_SECOND, type RobotConfig } from '@botgarten/simulation'
import { content } from '../files.ts'
import { cardDocument, type Card, type CardProgram } from '../index.ts'

addBlocks(learning)

export const seeds = sample([1, 2, 3, 4, 5, 6, 7, 8, 9, 10], 1)

/** What decides how a solution drives: brains that are to be repaired share all of it with the card they come from. */
function driveOf(id: string): string {
  const { world, starts, checks } = content.card(id)!.card
  return JSON.stringify([world, starts, checks, content.program(id, 'solution')])
}

const inBed = content.cards.filter(({ bed }) => bed === 'network').map(({ id }) => id)

/** The network cards in their order, one for each way to drive. */
export const networkCards = [...new Map(inBed.toReversed().map((id) => [driveOf(id), id])).values()].reverse()

type Run = (start: number, seed: number, errors: Partial<RobotConfig>) => string[]

/** A card's solution, to be let loose on robots that err. */
export interface Solved {
  readonly card: Card
  /** Ids of checks that have not passed at the end: after the card's time, at least 60 s. */
  readonly failures: Run
  /** The same five seconds after all of them have passed: what was reached has to last. */
  readonly lasting: Run
}

const failed = (lab: Lab) =>
  lab
    .view()
    .checks.filter(({ passed }) => !passed)
    .map(({ id }) => id)

/** `change`: what is done to the solution before. */
export function solved(id: string, change = (program: CardProgram) => program): Solved {
  const { card, world } = content.card(id)!
  const floor = content.floorOf(world)
  const program = change(content.program(id, 'solution')!)
  const seconds = Math.max(60, ...card.checks.map((one) => one.seconds))

  function open(start: number, seed: number, errors: Partial<RobotConfig>): Lab {
    const document = cardDocument(world, card, program, start)
    const [robot, ...others] = document.world.robots
    const robots = [{ ...robot!, config: { ...robot!.config, ...errors } }, ...others]
    const lab = createLab()
    lab.load({ ...document, world: { ...document.world, robots } }, floor, { seed, checks: card.checks })
    lab.start()
    return lab
  }

  return {
    card,
    failures(start, seed, errors) {
      const lab = open(start, seed, errors)
      lab.advance(seconds * TICKS_PER_SECOND)
      return failed(lab)
    },
    lasting(start, seed, errors) {
      const lab = open(start, seed, errors)
      for (let second = 0; second < seconds && failed(lab).length > 0; second += 1)
        lab.advance(TICKS_PER_SECOND)
      lab.advance(5 * TICKS_PER_SECOND)
      return failed(lab)
    },
  }
}
