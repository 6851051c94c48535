import { expect, test } from 'vitest'
import { ago, runsOf, type BedCard } from './home.ts'

const now = Date.UTC(2026, 10, 21, 12)

test('the last save is told in the largest whole unit', () => {
  expect(ago(now - 2 * 60_000, now, 'en')).toBe('2 minutes ago')
  expect(ago(now - 3 * 3_600_000 - 59 * 60_000, now, 'de')).toBe('vor 3 Stunden')
  expect(ago(now - 86_400_000, now, 'de')).toBe('gestern')
})

test('a clock that was set back does not tell the future', () => {
  expect(ago(now + 5000, now, 'en')).toBe('this minute')
})

test('cards of a group lie together, in the order of the bed', () => {
  const card = (number: string, group: BedCard['group'] = null) =>
    ({ href: `/lab/${number}`, number, label: number, level: { passed: 0, of: 3 }, group }) satisfies BedCard
  const runs = runsOf([card('8'), card('9', 'repair'), card('10', 'repair'), card('12'), card('13')])
  expect(runs.map(({ group, cards }) => [group, cards.map(({ number }) => number)])).toEqual([
    [null, ['8']],
    ['repair', ['9', '10']],
    [null, ['12', '13']],
  ])
})
