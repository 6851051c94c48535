import { noExamples, withDrive, type Examples } from '@botgarten/learning/neural-network/examples'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { lastTicks, shownRows, turnOf, withAllOn, withOn, withoutLast, withWish } from './table.ts'

const drive = (
  examples: Examples,
  id: string,
  rows: readonly (readonly [number, number, number, number])[],
) =>
  withDrive(
    examples,
    { id, by: 'pad', seed: 1 },
    rows.map(([a, b, l, r], k) => ({
      ...{ tick: 6 * k, pose: { x: 10, y: 20, heading: 30 }, inputs: [a, b], outputs: [l, r] },
    })),
  ).examples

const table = drive(
  drive(noExamples(['a', 'b'], ['l', 'r']), 'pad-1', [
    [10, 20, 30, 40],
    [50, 60, 70, 80],
  ]),
  'pad-2',
  [
    [1, 2, 3, 4],
    [11, 12, 13, 14],
    [21, 22, 23, 24],
  ],
)

test('rows have the columns of the neurons on the screen, and gaps for those they do not know', () => {
  const [first] = shownRows(table, ['b', 'new', 'a'], ['r'])
  expect(first).toMatchObject({ number: 1, on: true, inputs: [20, null, 10], outputs: [40] })
  expect(first!.pose).toEqual({ x: 10, y: 20, heading: 30 })
})

test('a row at 0, 0 comes from a table without poses; one on the edge of the world has a pose', () => {
  const rows = [[0, 0], [0, 7], [7, 0]].map(([x, y], k) => ({
    ...{ tick: k, pose: { x: x!, y: y!, heading: 30 }, inputs: [10 * k], outputs: [2] },
  })) // prettier-ignore
  const { examples } = withDrive(noExamples(['a'], ['l']), { id: 'pad-1', by: 'pad', seed: 1 }, rows)
  expect(shownRows(examples, ['a'], ['l']).map(({ pose }) => pose)).toEqual([
    null,
    { x: 0, y: 7, heading: 30 },
    { x: 7, y: 0, heading: 30 },
  ])
})

test('set aside and back is nothing', () => {
  fc.assert(
    fc.property(fc.uniqueArray(fc.nat(4)), (rows) => {
      expect(withAllOn(withAllOn(table, rows, false), rows, true)).toEqual(table)
    }),
    { seed: 3 },
  )
  expect(withOn(table, 2, true)).toBe(table)
})

test('a wish is cut to what a wheel can do, and what is no number changes nothing', () => {
  expect(shownRows(withWish(table, 1, 'l', 250), ['a', 'b'], ['l', 'r'])[1]!.outputs).toEqual([100, 80])
  expect(withWish(table, 1, 'l', NaN)).toBe(table)
  expect(withWish(table, 1, 'nobody', 5)).toBe(table)
})

test('the last drive goes as one', () => {
  const left = withoutLast(table)!
  expect(left.drives.map(({ id }) => id)).toEqual(['pad-1'])
  expect(left.rows).toHaveLength(2)
  expect(withoutLast(withoutLast(left)!)).toBeUndefined()
})

test('the last seconds are those of the last drive alone', () => {
  expect(lastTicks(table, 7)).toEqual([3, 4])
  expect(lastTicks(table, 600)).toEqual([2, 3, 4])
})

test('what both wheels do together has a name', () => {
  expect(turnOf(0, 2)).toBe('stand')
  expect(turnOf(60, 62)).toBe('straight')
  expect(turnOf(20, 60)).toBe('left')
  expect(turnOf(60, 20)).toBe('right')
  expect(turnOf(-50, -50)).toBe('back')
})
