import { expect, test } from 'vitest'
import { runsOf, type BedCard } from './home.ts'

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
