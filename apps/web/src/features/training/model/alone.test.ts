import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { expect, test } from 'vitest'
import { driveAlone, unseenStarts } from './alone.ts'

const found = content.card('friendship')!
const { world, card } = found

function course(solved: boolean) {
  const program = content.program('friendship', solved ? 'solution' : 'start')!
  const document = cardDocument(world, card, program, 0)
  return {
    ...{ document, floor: content.floorOf(document.world), checks: card.checks },
    robot: document.world.robots[0]!.id,
    network: { id: 'net', inputs: ['eyeLeft', 'eyeRight'] },
  }
}

function toEnd<Result>(steps: Generator<undefined, Result>): Result {
  for (;;) {
    const { done, value } = steps.next()
    if (done) return value
  }
}

test('unseen starts are near those of the card, none is one of them, and a seed gives the same ones', () => {
  const starts = unseenStarts(card.starts, world.size, 12, 1)
  expect(starts).toEqual(unseenStarts(card.starts, world.size, 12, 1))
  starts.forEach(({ x, y, heading }, k) => {
    const near = card.starts[k % card.starts.length]!
    expect(Math.hypot(x - near.x, y - near.y)).toBeGreaterThan(0)
    expect(Math.abs(x - near.x)).toBeLessThanOrEqual(25)
    expect(Math.abs(y - near.y)).toBeLessThanOrEqual(25)
    expect(Math.abs(heading - near.heading)).toBeLessThanOrEqual(20)
  })
})

test('the solution passes from most unseen starts, and a Bo that stands from none', () => {
  const starts = unseenStarts(card.starts, world.size, 4, 1)
  const passed = (solved: boolean) => toEnd(driveAlone(course(solved), starts)).filter((one) => one.passed)
  expect(passed(true).length).toBeGreaterThanOrEqual(3)
  expect(passed(false)).toEqual([])
})

test('without a card it has to drive and must not bump', () => {
  const starts = unseenStarts([], world.size, 2, 1)
  const tried = toEnd(driveAlone({ ...course(false), checks: [] }, starts))
  expect(tried.map(({ passed }) => passed)).toEqual([false, false])
})

test('without a card it passes where it drives 1 m and bumps into nothing', () => {
  const open = { x: world.size.width / 2, y: world.size.height / 2, heading: 0 }
  const empty = { ...course(true).document.world, obstacles: [] }
  const document = { ...course(true).document, world: empty }
  const [tried] = toEnd(driveAlone({ ...course(true), document, checks: [] }, [open]))
  expect(tried).toMatchObject({ number: 1, passed: true, missed: '' })
})

test('where a start is missed it is known what Bo read there', () => {
  const [stood] = toEnd(driveAlone(course(false), unseenStarts(card.starts, world.size, 1, 1)))
  expect(stood!.passed).toBe(false)
  expect(stood!.readings).toHaveLength(2)
  for (const value of stood!.readings!) {
    expect(value).toBeGreaterThanOrEqual(0)
    expect(value).toBeLessThanOrEqual(100)
  }
})
