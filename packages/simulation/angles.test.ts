import fc from 'fast-check'
import { expect, test } from 'vitest'
import { degreesOf, radiansOf, samePose } from './index.ts'

const pose = (heading: number, x = 20) => ({ x, y: 30, heading })

test.each([
  [-90, 270],
  [-3, 357],
  [0, 360],
  [359.9999999, 0],
  [-720, 0],
])('%d and %d look the same way', (a, b) => {
  expect(samePose(pose(a), pose(b))).toBe(true)
  expect(samePose(pose(b), pose(a))).toBe(true)
})

test('another way to look is another pose, and so is another place', () => {
  expect(samePose(pose(-90), pose(90))).toBe(false)
  expect(samePose(pose(0), pose(359.9))).toBe(false)
  expect(samePose(pose(0), pose(0, 20.001))).toBe(false)
})

test('a pose is the same after its heading was kept in radians', () => {
  fc.assert(
    fc.property(fc.integer({ min: -720, max: 720 }), (heading) => {
      expect(samePose(pose(heading), pose(degreesOf(radiansOf(heading))))).toBe(true)
    }),
  )
})
