import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { createLab } from '@botgarten/lab'
import { sample } from '@botgarten/numbers/testing'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardDocument } from '../index.ts'

addBlocks(learning)
const seeds = sample([1, 2, 3, 4, 5, 6, 7, 8, 9, 10], 1)

// The sensor of these worlds is noisy: another seed is another run.
describe.each(content.cards.filter(({ bed }) => bed === 'sorting'))('$id', ({ id }) => {
  const { card, world } = content.card(id)!

  function runWith(seed: number, file: string, start: number) {
    const document = cardDocument(world, card, content.program(id, file)!, start)
    const lab = createLab()
    lab.load(document, content.floorOf(world), { seed, checks: card.checks })
    lab.start()
    lab.advance(60 * TICKS_PER_SECOND)
    return {
      passed: lab.view().checks.every(({ passed }) => passed),
      readings: lab.state().threads[0]!.sorting.readings,
    }
  }

  it('the noise of two seeds is not the same', () => {
    expect(runWith(1, 'solution', 0).readings).not.toEqual(runWith(2, 'solution', 0).readings)
  })

  it.each(seeds)('the solution passes with seed %i from every start pose', (seed) => {
    for (const start of card.starts.keys()) expect(runWith(seed, 'solution', start).passed).toBe(true)
  })

  it.each(content.wrongAnswers(id))('the wrong answer %s is refused with every seed', (name) => {
    for (const seed of seeds) expect(runWith(seed, `wrong/${name}`, 0).passed).toBe(false)
  })
})
