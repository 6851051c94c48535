import { expect, test } from 'vitest'
import { sets } from '#figures/things/sets.ts'
import { fieldIn } from './geometry.ts'
import { firstWork } from './kept.ts'
import { centreOn, flagsOn, isOnTrays, spotsOn, traysIn } from './trays.ts'
import { withFeature, workOfSet } from './work.ts'

const field = fieldIn({ width: 760, height: 540 })
const only = (set: string, feature: string) => {
  const work = workOfSet(firstWork(), set)
  const alone = work.counting.reduce((left, one) => withFeature(left, one, false), work)
  return withFeature(alone, feature, true)
}

test('one feature of words alone lies on trays; numbers, colours and two features on the plane', () => {
  for (const { id, features } of sets)
    for (const { id: feature, kind } of features)
      expect(isOnTrays(only(id, feature)), `${id} ${feature}`).toBe(kind === 'choice')
  expect(isOnTrays(withFeature(only('vessels', 'material'), 'width', true))).toBe(false)
})

test('trays lie side by side from edge to edge, each with its middle half way between its edges', () => {
  const trays = traysIn(field, 4)
  const ends = trays.map(({ left, width }) => left + width)
  expect([trays[0]!.left, ends[3]]).toEqual([field.left, field.left + field.width])
  trays.slice(1).forEach(({ left }, before) => expect(left).toBeGreaterThan(ends[before]!))
  for (const { left, top, width, height, x, y } of trays)
    expect([x - left, y - top]).toEqual([
      expect.closeTo(width / 2, 9) as number,
      expect.closeTo(height / 2, 9) as number,
    ])
})

test('every thing lies on the tray of its word, in its edges, and apart from the others', () => {
  const { rows, columns } = only('vessels', 'material').table
  const trays = traysIn(field, columns.length)
  const spots = spotsOn(trays, rows, 47)
  expect(spots).toHaveLength(rows.length)
  rows.forEach((row, thing) => {
    const tray = trays[row.findIndex((value) => value > 0)]!
    expect(spots[thing]!.x).toBeGreaterThan(tray.left)
    expect(spots[thing]!.x).toBeLessThan(tray.left + tray.width)
    spots
      .slice(thing + 1)
      .forEach((other) =>
        expect(Math.hypot(other.x - spots[thing]!.x, other.y - spots[thing]!.y)).toBeGreaterThan(44),
      )
  })
})

test('a flag that is set on a tray means its word, and stands over that tray', () => {
  const trays = traysIn(field, 3)
  const centre = centreOn(trays, trays[1]!.x + 20, 7)
  expect(centre).toEqual([0, 7, 0])
  expect(flagsOn(trays, [centre])[0]!.x).toBeCloseTo(trays[1]!.x, 9)
})

test('a flag that means no word, as the median of three different words, is in the middle of all trays', () => {
  const trays = traysIn(field, 3)
  expect(flagsOn(trays, [[0, 0, 0]])[0]!.x).toBeCloseTo(field.left + field.width / 2, 9)
})
