import { expect, test } from 'vitest'
import { asShown, inOrder, pressed, statisticsOf, type Order } from './order.ts'
import type { ShownRow } from './table.ts'

const row = (at: number, drive: string, inputs: (number | null)[], outputs: number[]): ShownRow => ({
  ...{ at, number: at + 1, on: true, pose: null, inputs, outputs },
  drive: { id: drive, by: 'pad', seed: 1 },
})
const rows = [
  row(0, 'a', [40], [50, 50]),
  row(1, 'a', [10], [20, 60]),
  row(2, 'b', [null], [60, 20]),
  row(3, 'b', [40], [10, 80]),
]
const wheels = { left: 0, right: 1 }
const errors = new Map([
  [0, 0.1],
  [1, 0.4],
  [3, 0.2],
])
const numbers = (order: Partial<Order>) =>
  inOrder(rows, { ...asShown, ...order }, { errors, wheels }).map(({ number }) => number)

test('rows are sorted by a column, equal ones as they stand and gaps last', () => {
  expect(numbers({})).toEqual([1, 2, 3, 4])
  expect(numbers({ by: 0 })).toEqual([2, 1, 4, 3])
  expect(numbers({ by: 0, isDown: true })).toEqual([1, 4, 2, 3])
  expect(numbers({ by: 2 })).toEqual([3, 1, 2, 4])
})

test('sorted by error the worst comes first, and what has none last', () => {
  expect(pressed(asShown, 'error')).toMatchObject({ by: 'error', isDown: true })
  expect(numbers({ by: 'error', isDown: true })).toEqual([2, 4, 1, 3])
})

test('a drive or a way alone can be seen', () => {
  expect(numbers({ drive: 'b' })).toEqual([3, 4])
  expect(numbers({ turn: 'left' })).toEqual([2, 4])
  expect(numbers({ turn: 'left', drive: 'b' })).toEqual([4])
})

test('a heading sorts up, then down, then not at all', () => {
  const once = pressed(asShown, 1)
  expect(once).toMatchObject({ by: 1, isDown: false })
  expect(pressed(once, 1)).toMatchObject({ by: 1, isDown: true })
  expect(pressed(pressed(once, 1), 1)).toEqual(asShown)
  expect(pressed(once, 0)).toMatchObject({ by: 0, isDown: false })
})

// Moore, McCabe: Introduction to the Practice of Statistics; 2 4 4 4 5 5 7 9 has mean 5 and deviation 2.
test('a column has its mean, its spread, its least and its most; gaps do not count', () => {
  expect(statisticsOf([2, 4, 4, null, 4, 5, 5, 7, 9])).toEqual({ mean: 5, spread: 2, least: 2, most: 9 })
  expect(statisticsOf([null])).toBeNull()
})
