import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { flagCurve } from './elbow.ts'
import { firstWork } from './kept.ts'
import { traps } from './traps.ts'
import { withoutPoints, workOfSet, workOfTrap } from './work.ts'

/** Points and least inertia of 1 to 6 groups, by scikit-learn. */
const reference = JSON.parse(
  readFileSync(
    new URL('../../../../../../packages/learning/k-means/reference/elbows.json', import.meta.url),
    'utf8',
  ),
) as { readonly [name: string]: { readonly points: number[][]; readonly inertia: readonly number[] } }

test('the reference has the points of the playground', () => {
  for (const [name, { rows }] of Object.entries(traps)) expect(reference[name]!.points).toEqual(rows())
})

test.each([
  ['heaps', 3],
  ['few', 5],
  ['outlier', 3],
  ['many', null],
])('the curve of the %s has its elbow at %s flags', (name, elbow) => {
  const curve = [...flagCurve(workOfTrap(firstWork(), name))].at(-1)!
  expect(curve.elbow).toBe(elbow)
  curve.inertia.forEach((value, at) => expect(value / reference[name]!.inertia[at]!).toBeCloseTo(1, 2))
})

test('it grows by one number of flags a step; the vessels fall from 213 over 47 to 16, with a bend at 4', () => {
  const steps = [...flagCurve(workOfSet(firstWork(), 'vessels'))]
  expect(steps.map(({ inertia }) => inertia.length)).toEqual([1, 2, 3, 4, 5, 6])
  expect(steps.map(({ elbow }) => elbow)).toEqual([null, null, null, null, null, 4])
  const { inertia } = steps.at(-1)!
  expect([inertia[0], inertia[2], inertia[4]].map((value) => Math.round(value!))).toEqual([213, 47, 16])
})

test('without points there is no curve', () => {
  expect([...flagCurve(withoutPoints(firstWork()))]).toEqual([])
})
