import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { withLearnedWay } from '@botgarten/maps'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { loadCard } from '#content/cards.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { language } from '#words/language.svelte.ts'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import {
  byHand,
  cardIds,
  isSameSolution,
  listOf,
  outcomesOf,
  reasonFor,
  reasons,
  type Outcome,
} from './praise.ts'

addBlocks(learning)
addBlocks(expert)
beforeAll(async () => {
  await freshDevice()
  await language.speak('en')
})
afterAll(closeSessions)

const outcomes: Outcome[] = []

describe.each(cardIds)('the card %s', (id) => {
  const of = outcomesOf(id)
  outcomes.push(...of)

  test('does not praise a child who only presses Start, or does nothing', () => {
    expect(
      of.filter(({ attempt, all }) => (attempt === 'start' || attempt === 'untouched') && all > 0),
    ).toEqual([])
  })

  test('praises the solution of the card before only where it is its own', () => {
    const before = of.find(({ attempt }) => attempt === 'before')
    if (!isSameSolution(id)) expect(before?.all ?? 0).toBe(0)
  })

  test('lets a goal turn green only where a reason says that it is reached', () => {
    const green = of.flatMap(({ attempt, green: goals }) => (attempt === 'moved' ? [] : [...goals.keys()]))
    expect(green.filter((goal) => reasonFor(id, goal) === undefined)).toEqual([])
    const own = reasons.filter((reason) => reason.startsWith(`${id} `))
    expect(own.filter((reason) => !green.includes(reason.split(' ')[1]!))).toEqual([])
  })

  test('counts no run from a place moved by hand, whatever it reaches', async () => {
    const card = (await loadCard(id))!
    const fresh = cardProject(card.world, card.card, content.program(id, 'solution')!, id)
    const { session } = sessionOf(withLearnedWay(fresh, content.mapFile), { card })
    session.learnFirst = () => false
    const { pose } = session.robot
    if (card.card.playground === 'q-learning') session.starts = () => [pose]
    const { x, y, heading } = pose
    const after = { x: x + byHand.x, y: y + byHand.y, heading: heading + byHand.heading }
    session.apply({ kind: 'place', id: session.robotId, after })
    session.start()
    expect([session.beganElsewhere, session.noteSuccess(), session.progress.starts]).toEqual([
      true,
      false,
      [],
    ])
    session.lab.stop()
    session.toStart()
    session.start()
    expect([session.beganElsewhere, session.noteSuccess()]).toEqual([false, true])
  })
})

test('the list of what is praised is the one that is committed', async () => {
  await expect(listOf(outcomes)).toMatchFileSnapshot('../../../../../../benchmarks/results/praise.md')
})
