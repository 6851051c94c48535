import { expect, test } from 'vitest'
import { agoOf, seenTile, trailOf, type Live } from './live.ts'

const now = Date.UTC(2026, 10, 24, 9)
const live: Live = {
  ...{ card: 'friendship', project: 'p', checks: ['passed', 'open'], failed: 0, running: false },
  ...{ size: [600, 400], pose: null, trail: [1, 2, 3, 4, 5], seenAt: now - 4000, changedAt: now - 9000 },
}
const tile = { id: '1', nickname: 'Otter', isNew: false, locked: false, handAt: null, live }

test('a tile shows whether its pupil is here, is done, and needs somebody', () => {
  expect(seenTile(tile, now)).toMatchObject({ here: true, done: false, need: null })
  const all = { ...tile, live: { ...live, checks: ['passed', 'passed'] as const } }
  expect(seenTile(all, now)).toMatchObject({ done: true })
  expect(seenTile({ ...tile, live: { ...live, checks: [] } }, now)).toMatchObject({ done: false })
  expect(seenTile(tile, now + 60_000)).toMatchObject({ here: false })
  expect(seenTile({ ...tile, live: null, handAt: now }, now)).toMatchObject({
    here: false,
    need: { kind: 'hand' },
  })
})

test('a trail is points; half a point at its end is left out', () => {
  expect(trailOf(live)).toEqual([
    { x: 1, y: 2 },
    { x: 3, y: 4 },
  ])
})

test('a clock that runs behind shows no time below zero', () => {
  expect(agoOf(now + 5000, now)).toEqual({ unit: 'seconds', count: 0 })
  expect(agoOf(now - 59_999, now)).toEqual({ unit: 'seconds', count: 59 })
  expect(agoOf(now - 61_000, now)).toEqual({ unit: 'minutes', count: 1 })
})
