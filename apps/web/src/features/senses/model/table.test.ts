import type { TableBrain } from '@botgarten/learning/q-senses'
import { expect, test } from 'vitest'
import { bestOf, fanOf, keepRows, rowsOf, sizeOf } from './table.ts'

const eye = (port: '2' | '3') => ({ port, mode: 'distance' }) as const

function tableOf(values: { readonly [cell: number]: number }, more: Partial<TableBrain> = {}): TableBrain {
  const trial = {
    sensors: [eye('2'), eye('3')],
    edges: [
      [15, 40],
      [15, 40],
    ],
    bump: true,
    ...more,
  }
  const states = trial.edges.reduce((product, edges) => product * (edges.length + 1), 1) + 1
  const q = Array.from({ length: states * 3 }, (_, cell) => values[cell] ?? 0)
  return {
    ...{
      kind: 'table',
      hold: 15,
      pay: [],
      bumpEnds: false,
      alpha: 0.2,
      gamma: 0.9,
      rho: 0.2,
      seed: 1,
      moves: 9,
    },
    ...trial,
    actions: [
      { left: 50, right: 50 },
      { left: -25, right: 25 },
      { left: 25, right: -25 },
    ],
    ...{ q, tries: q.map((_, cell) => (cell in values ? 1 : 0)) },
  }
}

test('two eyes of three buckets and the bump are ten rows, the bump the last one', () => {
  const rows = rowsOf(tableOf({}))
  expect(rows).toHaveLength(10)
  expect(rows.map(({ buckets }) => buckets)).toEqual([
    ...[
      [0, 0],
      [0, 1],
      [0, 2],
      [1, 0],
      [1, 1],
      [1, 2],
      [2, 0],
      [2, 1],
      [2, 2],
    ],
    null,
  ])
  expect(sizeOf(tableOf({}))).toEqual({ buckets: [3, 3], bump: true, states: 10 })
})

test('best is what Bo takes: nothing untried, all of several alike, and no loss where something is untried', () => {
  const rows = rowsOf(tableOf({ 0: 1.5, 1: 0.5, 3: -1, 6: 0, 7: 0, 9: -2, 10: -1, 11: -3 }))
  const marked = (state: number) => rows[state]!.cells.map(({ best }) => best)
  expect(marked(0)).toEqual([true, false, false])
  // Of these two nobody has tried, and what was tried cost something: one of the two is next.
  expect(marked(1)).toEqual([false, false, false])
  expect(marked(2)).toEqual([true, true, false])
  expect(marked(3)).toEqual([false, true, false])
  expect(rows.slice(0, 4).map(bestOf)).toEqual([0, null, null, 1])
})

test('the fan has the fields of both eyes, the left one first, whichever stands first in the table', () => {
  const table = tableOf({ 6: 1, 18: 0, 19: 2 })
  const rows = rowsOf(table)
  const fan = fanOf(table, rows, 2, false)
  expect(fan.fields[0]).toEqual([null, null, 0])
  expect(fan.fields[2]).toEqual([1, null, null])
  expect(fan.now).toEqual([0, 2])
  const flipped = fanOf(table, rows, 2, true)
  expect(flipped.fields[2]![0]).toBe(0)
  expect(flipped.now).toEqual([2, 0])
})

test('a bump lights none of its fields, and a third sensor shows those of what it senses now', () => {
  const table = tableOf({})
  expect(fanOf(table, rowsOf(table), 9, false).now).toBeNull()
  const three = tableOf(
    { 3: 4 },
    { sensors: [eye('2'), eye('3'), { port: '1', mode: 'touch' }], edges: [[15, 40], [15, 40], [1]] },
  )
  const rows = rowsOf(three)
  expect(fanOf(three, rows, 0, false).fields[0]![0]).toBeNull()
  expect(fanOf(three, rows, 1, false).fields[0]![0]).toBe(0)
})

test('one sensor is a row of fields', () => {
  const table = tableOf({ 3: 1 }, { sensors: [eye('2')], edges: [[15, 40]] })
  expect(fanOf(table, rowsOf(table), 1, false)).toMatchObject({ fields: [[null], [0], [null]], now: [1, 0] })
})

test('a trial of too many states has no table at all', () => {
  expect(rowsOf({ ...tableOf({}), q: [], tries: [] })).toEqual([])
  expect(rowsOf({ ...tableOf({}), actions: [], q: [], tries: [] })).toEqual([])
})

test('rows in which nothing has changed stay the same objects, and all of them where none has', () => {
  const before = rowsOf(tableOf({ 3: 1, 7: 2 }))
  expect(keepRows(before, rowsOf(tableOf({ 3: 1, 7: 2 })))).toBe(before)
  const now = rowsOf(tableOf({ 3: 1, 7: 2.5 }))
  const kept = keepRows(before, now)
  expect(kept).toEqual(now)
  expect(kept.map((row, state) => row === before[state])).toEqual(before.map((_, state) => state !== 2))
})

test('of a table of another shape no row stays', () => {
  const before = rowsOf(tableOf({}))
  const other = rowsOf(tableOf({}, { sensors: [eye('2')], edges: [[15, 40]] }))
  expect(keepRows(before, other)).toEqual(other)
  expect(keepRows(other, before)).toEqual(before)
  expect(keepRows([], before)).toEqual(before)
})
