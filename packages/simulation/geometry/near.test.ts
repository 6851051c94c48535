import { expect, test } from 'vitest'
import { createNearParts, findNear, type Ground } from './near.ts'
import { createOutlines, moveBody } from './outlines.ts'

/** Discs of 5 cm in a row, 1 cm between them, far from every edge. */
function rowOf(count: number): Ground {
  const outlines = createOutlines(
    Array.from({ length: count }, () => [{ kind: 'circle', radius: 5 } as const]),
  )
  for (let body = 0; body < count; body++) moveBody(outlines, body, 100 + 11 * body, 100, 0)
  return { width: 400, height: 200, outlines, movable: new Uint8Array(count).fill(1) }
}

test.each([
  ['all move', [1, 1, 1, 1]],
  ['the first moves', [1, 0, 0, 0]],
  ['one in the middle moves', [0, 0, 1, 0]],
])('what may touch is found once, and spreads over all that could be pushed: %s', (_which, moving) => {
  const near = createNearParts(4)
  findNear(rowOf(4), Uint8Array.from(moving), 2, near)
  const pairs = Array.from({ length: near.count }, (_, k) => [near.a[k]!, near.b[k]!].sort().join('-'))
  expect(pairs.sort()).toEqual(['0-1', '1-2', '2-3'])
})

test('nothing is near where the gaps are as wide as the margin', () => {
  const near = createNearParts(4)
  findNear(rowOf(4), Uint8Array.from([1, 1, 1, 1]), 1, near)
  expect(near.count).toBe(0)
})
