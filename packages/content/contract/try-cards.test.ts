import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { watchedIn } from '@botgarten/experiments/cages'
import { tryOut } from '@botgarten/experiments/trying'
import { createLab } from '@botgarten/lab'
import { beginNight, tableOf, ticksOf } from '@botgarten/lab/trying'
import { sample } from '@botgarten/numbers/testing'
import { tryingIn, type TryOutline } from '@botgarten/programs'
import { TICKS_PER_SECOND, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardDocument, worldAt, type Card } from '../index.ts'

addBlocks(learning)

/** Cards on which a robot learns by trying with its sensors. */
const tryCards = content.cards.map(({ id }) => id).filter((id) => content.program(id, 'solution')?.tables)

/** What came of a trial with 20 seeds; of cards that differ in nothing but their own seed it is worked out once. */
const tried = new Map<string, readonly (number | null)[]>()
function firstMinutes(card: Card, worlds: readonly World[], { trial, minutes }: TryOutline) {
  const key = JSON.stringify([card.world, card.starts, { ...trial, seed: 0 }, minutes])
  const known = tried.get(key)
  if (known) return known
  const floor = content.floorOf(worlds[0]!)
  const firsts = Array.from(
    { length: 20 },
    (_, k) => tryOut(worlds, floor, { ...trial, seed: k + 1 }, minutes).first,
  )
  tried.set(key, firsts)
  return firsts
}

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
    const outline = outlineOf('solution')
    expect(outline.minutes).toBeLessThanOrEqual(8)
    const firsts = firstMinutes(card, worlds, outline)
    expect(firsts.filter((first) => first !== null).length).toBeGreaterThanOrEqual(19)
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

describe('the card of the zoo', () => {
  const { card, world } = content.card('zoo')!
  const { numbers } = card.checks.find(({ kind }) => kind === 'neverCheats')!
  const { cage } = content.senseCages.find((one) => one.cage.id === numbers['animal'])!
  const place = {
    worlds: card.starts.map((_, start) => worldAt(world, card, start)),
    floor: content.floorOf(world),
  }

  it('knows its cheat by the numbers of the cage, on its floor and from its starts', () => {
    const ranges = Object.entries(cage.cheats).map(([name, range]) => [name, ...range].join(' '))
    expect(numbers['cheats']).toBe(ranges.join(', '))
    expect([card.world, card.starts]).toEqual([cage.world, cage.starts])
  })

  it.each([
    ['start', true],
    ['solution', false],
  ])('the table of its %s: cheating is %s', (file, cheats) => {
    const [table] = Object.values(content.program('zoo', file)!.tables!)
    expect(watchedIn(cage, place, table!).cheats).toBe(cheats)
  })

  it('names the trick of the animal that is given, after half a minute', () => {
    const lab = createLab()
    lab.load(cardDocument(world, card, content.program('zoo', 'start')!, 0), place.floor, {
      seed: 1,
      checks: card.checks,
    })
    expect(lab.missing()[0]).toMatchObject({ check: 'cheats', what: 'untried' })
    lab.start()
    lab.advance(31 * TICKS_PER_SECOND)
    expect(lab.missing()[0]).toMatchObject({ check: 'cheats', what: 'trick', facts: { animal: 'gazer' } })
  })
})
