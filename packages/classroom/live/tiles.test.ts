import fc from 'fast-check'
import { expect, test } from 'vitest'
import { inOrder, isHere, needOf, type Live, type Tile } from './tiles.ts'

const now = 10_000_000
const minute = 60_000

const live = (changes: Partial<Live> = {}): Live => ({
  ...{ card: 'friendship', project: null, checks: ['open', 'open'], failed: 0, running: false },
  ...{ size: null, pose: null, trail: [], seenAt: now, changedAt: now },
  ...changes,
})
const tile = (nickname: string, changes: Partial<Tile> = {}): Tile => ({
  ...{ id: nickname, nickname, isNew: false, locked: false, handAt: null, live: live() },
  ...changes,
})

test('three minutes without a change, five times the same check, or a hand: stuck', () => {
  const need = (changes: Partial<Tile>) => needOf(tile('Fuchs', changes), now)?.kind ?? null
  expect(need({ live: live({ changedAt: now - 3 * minute }) })).toBe('noChange')
  expect(need({ live: live({ changedAt: now - 3 * minute + 1 }) })).toBeNull()
  expect(need({ live: live({ failed: 5 }) })).toBe('sameCheck')
  expect(need({ live: live({ failed: 4 }) })).toBeNull()
  expect(need({ handAt: now - minute })).toBe('hand')
})

test('who has passed every check, or is not here, is not stuck; a hand stays up', () => {
  const passed = live({ checks: ['passed', 'passed'], changedAt: now - 9 * minute, failed: 7 })
  expect(needOf(tile('Fuchs', { live: passed }), now)).toBeNull()
  const gone = live({ seenAt: now - minute, changedAt: now - 9 * minute })
  expect(isHere({ live: gone }, now)).toBe(false)
  expect(needOf(tile('Fuchs', { live: gone }), now)).toBeNull()
  expect(needOf(tile('Fuchs', { live: gone, handAt: now - minute }), now)?.kind).toBe('hand')
})

test('hands come first, then checks, then silence, the longest first; the rest from A to Z', () => {
  const all = [
    tile('Zebra'),
    tile('Quiet', { live: live({ changedAt: now - 4 * minute }) }),
    tile('Check5', { live: live({ failed: 5 }) }),
    tile('HandLate', { handAt: now - 1000 }),
    tile('Check9', { live: live({ failed: 9 }) }),
    tile('Quieter', { live: live({ changedAt: now - 8 * minute }) }),
    tile('HandEarly', { handAt: now - 5000 }),
    tile('Ananas', { live: null }),
  ]
  expect(inOrder(all, now).map(({ nickname }) => nickname)).toEqual([
    'HandEarly',
    'HandLate',
    'Check9',
    'Check5',
    'Quieter',
    'Quiet',
    'Ananas',
    'Zebra',
  ])
})

test('the order does not depend on the order before, and loses nobody', () => {
  const some = fc.uniqueArray(
    fc.record({
      nickname: fc.stringMatching(/^[A-Z][a-z]{2,8}$/),
      handAt: fc.option(fc.nat(now), { nil: null }),
      failed: fc.nat(9),
      idle: fc.nat(500_000),
    }),
    { selector: ({ nickname }) => nickname, maxLength: 35 },
  )
  fc.assert(
    fc.property(some, fc.gen(), (pupils, gen) => {
      const tiles = pupils.map(({ nickname, handAt, failed, idle }, at) =>
        tile(nickname, { handAt: handAt && handAt - at, live: live({ failed, changedAt: now - idle - at }) }),
      )
      const shuffled = gen(fc.shuffledSubarray, tiles, { minLength: tiles.length })
      const key = (list: readonly Tile[]) => list.map((one) => needOf(one, now)?.kind ?? one.nickname)
      expect(key(inOrder(shuffled, now))).toEqual(key(inOrder(tiles, now)))
      expect(new Set(inOrder(tiles, now))).toEqual(new Set(tiles))
    }),
  )
})
