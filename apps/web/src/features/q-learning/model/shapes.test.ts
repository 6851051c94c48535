import { expect, test } from 'vitest'
import { curveOf, thinned } from './shapes.ts'

test('a curve of few episodes is drawn as it is, one of many in means', () => {
  expect(thinned([1, 2, 3])).toEqual([
    { x: 0, y: 1 },
    { x: 0.5, y: 2 },
    { x: 1, y: 3 },
  ])
  const many = thinned(Array.from({ length: 10_000 }, (_, k) => k))
  expect(many).toHaveLength(160)
  expect(many[0]!.y).toBeCloseTo(30.5)
})

test('episodes that say nothing leave a gap, and nothing at all is no curve', () => {
  expect(thinned([null, 4])).toEqual([{ x: 1, y: 4 }])
  expect(thinned([])).toEqual([])
  expect(curveOf([], 100, 50, 1)).toBe('')
})

test('y goes up', () => {
  expect(curveOf([{ x: 0, y: 0 }, { x: 1, y: 10 }], 100, 50, 10)).toBe('M0.0 50.0L100.0 0.0') // prettier-ignore
})
