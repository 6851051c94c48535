import { expect, test } from 'vitest'
import { Marked, placesOf } from './choices.svelte.ts'

test('a road that is pointed at is marked in its own direction, not others that share a station with it', () => {
  const marked = new Marked()
  marked.point([2, 5])
  expect([marked.is(2, 5), marked.is(5, 2), marked.is(2, 3), marked.is(4, 5)]).toEqual([
    ...[true, false],
    ...[false, false],
  ])
  marked.point(null)
  expect(marked.is(2, 5)).toBe(false)
})

test('a road that was tapped is marked in both directions, until a pointer shows another one', () => {
  const marked = new Marked()
  marked.chosen = { kind: 'road', a: 2, b: 10 }
  expect([marked.is(2, 10), marked.is(10, 2), marked.is(2, 3)]).toEqual([true, true, false])
  expect([marked.shownRoad, marked.station]).toEqual([[2, 10], null])
  marked.point([4, 1])
  expect(marked.shownRoad).toEqual([4, 1])
})

test('a station that was tapped is one place, a road two, start and goal none', () => {
  const marked = new Marked()
  marked.chosen = { kind: 'station', station: 0 }
  expect([marked.station, marked.shownRoad]).toEqual([0, null])
  expect(placesOf(marked.chosen)).toEqual(['0'])
  expect(placesOf({ kind: 'road', a: 2, b: 5 })).toEqual(['2-5', '5-2'])
  expect(placesOf({ kind: 'ends' })).toEqual([])
})
