import { content } from '@botgarten/content/files'
import type { RobotConfig } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { drawBo } from '#drawing/bo.ts'
import { boParts, leaders } from './robot.ts'
import fc from 'fast-check'

const { robots } = content.world('friendship')!
const friend = robots[0]!.config
const named = (config: RobotConfig) => boParts(config).map(({ kind, port }) => `${kind} ${port}`)

test('the parts of Bo are those of its configuration, and what every Bo has', () => {
  expect(named(friend).sort()).toEqual(
    ['colour 1', 'display null', 'lamp null', 'ultrasonic 2', 'ultrasonic 3', 'wheel B', 'wheel C'].sort(),
  )
})

test('a sensor that is plugged out is no part, and one inside the body is not seen', () => {
  const config = { ...friend, sensors: { '4': { kind: 'gyro', x: 0, y: 0, angle: 0 } } } as RobotConfig
  expect(named(config).filter((name) => /\d/.test(name))).toEqual([])
})

test('the left wheel is the motor that the configuration has on the left', () => {
  const swapped = { ...friend, drive: { left: 'A', right: 'D' } } as const
  const left = boParts(swapped).filter(({ kind, at }) => kind === 'wheel' && at.x < 0)
  expect(left.map(({ port }) => port)).toEqual(['A'])
})

test('an eye is named where it is drawn, on the head though it is said to sit beyond its edge', () => {
  const config = {
    ...friend,
    sensors: { '3': { kind: 'ultrasonic', x: 30, y: -30, angle: 0 } },
  } as RobotConfig
  const drawn = drawBo({ config, led: null, text: false }).flatMap((shape) =>
    shape.kind === 'group' && shape.turn !== undefined ? [{ x: shape.x, y: shape.y }] : [],
  )
  expect(drawn).toEqual([{ x: 4.2, y: -6.55 }])
  expect(boParts(config).find(({ port }) => port === '3')?.at).toEqual(drawn[0])
})

const spot = fc.record({ x: fc.integer({ min: -9, max: 9 }), y: fc.integer({ min: -9, max: 9 }) })

test('a name stands beside what it names where nothing is in the way', () => {
  expect(
    leaders(
      [
        { x: -2, y: 1 },
        { x: 3, y: 0 },
        { x: -2, y: 7 },
      ],
      4,
    ),
  ).toEqual([
    { side: 'left', y: 1 },
    { side: 'right', y: 0 },
    { side: 'left', y: 7 },
  ])
})

test('names that would cover each other make way both alike', () => {
  expect(
    leaders(
      [
        { x: 1, y: 1 },
        { x: 1, y: 0 },
      ],
      4,
    ),
  ).toEqual([
    { side: 'right', y: 2.5 },
    { side: 'right', y: -1.5 },
  ])
})

test('what stands in the middle is named where there is less', () => {
  const [, , eye] = leaders(
    [
      { x: 1, y: 0 },
      { x: 1, y: 5 },
      { x: 0, y: 2 },
    ],
    1,
  )
  expect(eye).toEqual({ side: 'left', y: 2 })
})

test('names never cover each other and stand in the order of what they name', () => {
  fc.assert(
    fc.property(fc.array(spot, { maxLength: 9 }), (spots) => {
      const named = leaders(spots, 3).map((leader, at) => ({ ...leader, spot: spots[at]! }))
      for (const a of named)
        for (const b of named) {
          if (a === b || a.side !== b.side) continue
          expect(Math.abs(a.y - b.y)).toBeGreaterThanOrEqual(3 - 1e-9)
          if (a.spot.y < b.spot.y) expect(a.y).toBeLessThan(b.y)
        }
    }),
    { seed: 5 },
  )
})
