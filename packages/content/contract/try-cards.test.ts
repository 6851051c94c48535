import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { tryOut } from '@botgarten/experiments/trying'
import { createLab } from '@botgarten/lab'
import { beginNight, tableOf, ticksOf } from '@botgarten/lab/trying'
import { sample } from '@botgarten/numbers/testing'
import { tryingIn } from '@botgarten/programs'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardDocument, worldAt } from '../index.ts'

addBlocks(learning)

/** Cards on which a robot learns by trying with its sensors. */
const tryCards = content.cards.map(({ id }) => id).filter((id) => content.program(id, 'solution')?.tables)

it('there is one', () => expect(tryCards).toContain('try-dodge'))

describe.each(tryCards)('%s', (id) => {
  const { card, world } = content.card(id)!
  const worlds = card.starts.map((_, start) => worldAt(world, card, start))
  const floor = content.floorOf(world)
  const outlineOf = (file: string) => tryingIn(content.program(id, file)!.programs['main']!)!

  it.each(['solution', ...content.wrongAnswers(id).map((name) => `wrong/${name}`)])(
    'the table of %s is learned again from its seed',
    (file) => {
      const { id: block, trial, minutes } = outlineOf(file)
      const night = beginNight(worlds[0]!, floor, trial)
      night.advance(ticksOf(minutes))
      expect(content.program(id, file)!.tables).toEqual({ [block]: tableOf(night.state) })
    },
  )

  it('at least 19 of 20 seeds come to drive from every start without a bump, within 8 minutes', () => {
    const { trial, minutes } = outlineOf('solution')
    const tried = Array.from({ length: 20 }, (_, k) =>
      tryOut(worlds, floor, { ...trial, seed: k + 1 }, minutes),
    )
    expect(minutes).toBeLessThanOrEqual(8)
    expect(tried.filter(({ first }) => first !== null).length).toBeGreaterThanOrEqual(19)
  })

  it.each(
    sample(
      card.starts.map((_, start) => start),
      1,
    ),
  )('a child that pays, presses Start at place %i and waits has solved it', (start) => {
    const { programs } = content.program(id, 'solution')!
    const lab = createLab()
    const document = cardDocument(world, card, { programs, brains: {} }, start)
    lab.load(document, floor, { seed: 1, checks: card.checks })
    lab.start()
    lab.advance((8 * 60 + 70) * TICKS_PER_SECOND)
    expect(lab.view().problem).toBeNull()
    expect(lab.view().checks.filter(({ passed }) => !passed)).toEqual([])
  })
})
