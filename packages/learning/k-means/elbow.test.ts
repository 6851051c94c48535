import { stream } from '@botgarten/numbers'
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { elbowOf, inertiaOfGroups, pointsOf } from './index.ts'

/** Made by reference/elbows.py. */
const reference = JSON.parse(readFileSync(new URL('reference/elbows.json', import.meta.url), 'utf8')) as {
  readonly [name: string]: { readonly points: number[][]; readonly inertia: readonly number[] }
}

const curveOf = (points: readonly (readonly number[])[], most = 6) => [
  ...inertiaOfGroups(pointsOf(points), most, {
    ...{ starts: 200, distance: 'euclidean', stream: stream(1, 'learn/sorting/flags') },
  }),
]

test.each(Object.entries(reference))(
  'the inertia of 1 to 6 groups is at most 0.5 %% above the least of scikit-learn, never below it, with one elbow: %s',
  (_, { points, inertia }) => {
    const curve = curveOf(points)
    for (const [at, value] of inertia.entries()) {
      expect(curve[at]! / value).toBeGreaterThan(1 - 1e-9)
      expect(curve[at]! / value).toBeLessThan(1.005)
    }
    expect(elbowOf(curve)).toBe(elbowOf(inertia))
  },
)

test('the elbow is at the number of heaps, and nowhere in one heap', () => {
  const elbow = (name: string) => elbowOf(reference[name]!.inertia)
  expect([elbow('heaps'), elbow('few'), elbow('many')]).toEqual([3, 5, null])
})

test('points that lie on their centres are an elbow, too', () => {
  expect(elbowOf(curveOf([[1, 1], [1, 1], [9, 9], [9, 9]]))).toBe(2) // prettier-ignore
})

test('no more groups than points, and no elbow in a curve of two', () => {
  expect(curveOf([[1], [3]])).toEqual([2, 0])
  expect([elbowOf([]), elbowOf([0, 0, 0]), elbowOf([2, 0])]).toEqual([null, null, null])
})

test('more groups are never worse', () => {
  for (const { points } of Object.values(reference)) {
    const curve = curveOf(points)
    expect(curve).toEqual(curve.toSorted((a, b) => b - a))
  }
})

test('a bend of log inertia by more than 0.4 is an elbow, and a smaller one is none', () => {
  // ln 100 − 2 ln 20 + ln 8 = 0.69, and with 6.5 in place of 8 ln 1.625 = 0.49; ln 100 − 2 ln 20 + ln 5.8 = 0.37.
  expect([8, 6.5, 5.8].map((last) => elbowOf([100, 20, last]))).toEqual([2, 2, null])
})
