import fc from 'fast-check'
import { expect, test } from 'vitest'
import { frameOf } from './frame.ts'

const size = { width: 600, height: 400 }
const block = { pose: { x: 300, y: 200, heading: 0 } } as never

test('Bo beside a block: both are in the picture', () => {
  const [left, top, width, height] = frameOf({ size, obstacles: [block] }, { x: 360, y: 210 })
    .split(' ')
    .map(Number)
  const isIn = (x: number, y: number) =>
    x > left! && x < left! + width! && size.height - y > top! && size.height - y < top! + height!
  expect(isIn(360, 210)).toBe(true)
  expect(isIn(300, 200)).toBe(true)
})

test('wherever Bo stands, it is at least 19 cm inside the picture', () => {
  const place = fc.record({
    x: fc.double({ min: -100, max: 700, noNaN: true }),
    y: fc.double({ min: -100, max: 500, noNaN: true }),
  })
  fc.assert(
    fc.property(place, fc.boolean(), (pose, empty) => {
      const [left, top, width, height] = frameOf({ size, obstacles: empty ? [] : [block] }, pose)
        .split(' ')
        .map(Number)
      const [x, y] = [pose.x - left!, size.height - pose.y - top!]
      expect(Math.min(x, width! - x, y, height! - y)).toBeGreaterThan(19)
    }),
  )
})

test('the picture moves from Bo towards the thing by three fifths of the way to it', () => {
  // 20 cm to the right and 10 cm up: 12 and 6 cm; the picture is 190 × 76 cm, its y goes down from 400.
  const frame = frameOf({ size, obstacles: [block] }, { x: 280, y: 190 })
  expect(frame).toBe(`${280 + 12 - 95} ${400 - (190 + 6) - 38} 190 76`)
})
