import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  aim,
  bringing,
  floorCorner,
  follow,
  fromPane,
  keepOnFloor,
  needOf,
  needOfAll,
  onFloor,
  scaleBar,
  scaleFor,
  toPane,
} from './camera.ts'

const floor = { width: 600, height: 400 }
const tall = { width: 372, height: 506 }
const low = { width: 519, height: 210 }
const block = { x: 300, y: 200, radius: 35 }

const panes = fc.record({
  width: fc.integer({ min: 200, max: 1600 }),
  height: fc.integer({ min: 150, max: 1000 }),
})
const spots = fc.record({ x: fc.integer({ min: 12, max: 588 }), y: fc.integer({ min: 12, max: 388 }) })

describe('the camera', () => {
  test('maps the floor to the pane and back', () => {
    const cameras = fc.record({
      x: fc.double({ min: 0, max: 600, noNaN: true }),
      y: fc.double({ min: 0, max: 400, noNaN: true }),
      scale: fc.double({ min: 0.5, max: 3, noNaN: true }),
    })
    fc.assert(
      fc.property(cameras, panes, spots, (camera, pane, spot) => {
        const back = fromPane(toPane(spot, camera, pane), camera, pane)
        expect(back.x).toBeCloseTo(spot.x, 6)
        expect(back.y).toBeCloseTo(spot.y, 6)
      }),
    )
  })

  test('rule 1: y grows upwards on the floor', () => {
    const camera = { x: 300, y: 200, scale: 2 }
    expect(toPane({ x: 310, y: 210 }, camera, tall)).toEqual({ x: 206, y: 233 })
    expect(onFloor({ x: 0, y: 400 }, floor, 2)).toEqual({ x: 0, y: 0 })
    expect(floorCorner(camera, tall, floor)).toEqual({ x: -414, y: -147 })
  })

  test('shows Bo and the blue square from a start of Friendship, below it in a tall pane, beside it in a low one', () => {
    const starts = [
      [tall, { x: 300, y: 70 }],
      [low, { x: 440, y: 170 }],
    ] as const
    for (const [pane, robot] of starts) {
      const scale = scaleFor(pane, floor, needOf(robot, [block]))
      const camera = aim(robot, [block], scale, pane, floor)
      for (const { x, y } of [robot, block]) {
        const at = toPane({ x, y }, camera, pane)
        expect(at.x > 0 && at.x < pane.width && at.y > 0 && at.y < pane.height).toBe(true)
      }
      expect(scale).toBeGreaterThan(2)
    }
    expect(scaleFor(tall, floor, needOf({ x: 300, y: 70 }, [block]))).toBe(2.6)
  })

  test('shows the whole floor where Bo stays big enough, and never more than 3 px a cm of it', () => {
    const small = { width: 300, height: 200 }
    expect(scaleFor({ width: 1000, height: 700 }, small, { width: 44, height: 100 })).toBe(3)
    expect(scaleFor({ width: 800, height: 524 }, small, { width: 44, height: 100 })).toBeCloseTo(2.5)
  })

  test('Bo, 21.5 cm wide, is 44 px at least, however far away the next thing is; less in a very small pane', () => {
    for (const pane of [tall, low, { width: 850, height: 506 }])
      for (const need of [110, 300, 600])
        expect(21.5 * scaleFor(pane, floor, { width: need, height: need })).toBeGreaterThanOrEqual(44)
    expect(scaleFor({ width: 360, height: 133 }, floor, { width: 600, height: 600 })).toBeCloseTo(1.4)
  })

  test('of several robots all are in sight where Bo stays big enough', () => {
    const need = needOfAll([
      { x: 100, y: 100 },
      { x: 200, y: 160 },
    ])
    expect(need).toEqual({ width: 144, height: 104 })
    expect(scaleFor(tall, floor, need)).toBeCloseTo(372 / 144)
  })

  test('shows all of a map, in a tall and in a low pane', () => {
    const track = { width: 400, height: 300 }
    for (const pane of [tall, { width: 400, height: 300 }]) {
      const scale = scaleFor(pane, track, 'whole')
      expect(scale * track.width).toBeLessThanOrEqual(pane.width)
      expect(scale * track.height).toBeLessThanOrEqual(pane.height)
    }
    expect(scaleFor({ width: 150, height: 150 }, track, 'whole')).toBe(0.8)
  })

  test('leans towards a thing that is a little too far away to be seen, and not towards one that is far away', () => {
    const robot = { x: 310, y: 330 }
    const y = (below: number) =>
      aim(robot, [{ x: 310, y: robot.y - below, radius: 25 }], 2.05, low, { width: 600, height: 900 }).y
    expect(y(125)).toBeLessThan(315)
    expect(y(260)).toBe(robot.y)
  })

  test('keeps the robot in sight wherever it is', () => {
    const things = fc.array(
      fc.record({
        x: fc.integer({ min: 0, max: 600 }),
        y: fc.integer({ min: 0, max: 400 }),
        radius: fc.integer({ min: 3, max: 80 }),
      }),
      { maxLength: 4 },
    )
    fc.assert(
      fc.property(panes, spots, things, (pane, robot, others) => {
        const scale = scaleFor(pane, floor, needOf(robot, others))
        const at = toPane(robot, aim(robot, others, scale, pane, floor), pane)
        expect(at.x >= 10 && at.x <= pane.width - 10 && at.y >= 10 && at.y <= pane.height - 10).toBe(true)
      }),
    )
  })

  test('brings both ends of a way into sight, and stays where both are seen', () => {
    const now = { x: 60, y: 170, scale: 2.05 }
    const ends = [
      { x: 60, y: 170 },
      { x: 300, y: 200 },
    ]
    const there = bringing(ends, now, low, floor)!
    for (const end of ends) {
      const { x, y } = toPane(end, there, low)
      expect(x > 20 && x < low.width - 20 && y > 20 && y < low.height - 20).toBe(true)
    }
    expect(there.scale).toBeLessThan(2.05)
    expect(bringing(ends, there, low, floor)).toBeNull()
  })

  test('never comes nearer to bring something into sight, nor goes farther than the whole floor', () => {
    fc.assert(
      fc.property(panes, spots, spots, fc.double({ min: 0.8, max: 3, noNaN: true }), (pane, a, b, scale) => {
        const there = bringing([a, b], { ...a, scale }, pane, floor)
        const whole = Math.min((pane.width - 24) / floor.width, (pane.height - 24) / floor.height)
        if (!there) return
        expect(there.scale).toBeLessThanOrEqual(scale)
        expect(there.scale).toBeGreaterThanOrEqual(Math.min(scale, whole))
      }),
    )
  })

  test('looks no further past the edge than the frame is wide', () => {
    const corner = keepOnFloor({ x: 0, y: 0, scale: 2 }, tall, floor)
    expect(floorCorner(corner, tall, floor)).toEqual({ x: 12, y: tall.height - 12 - 800 })
    expect(keepOnFloor({ x: 0, y: 0, scale: 0.5 }, tall, floor)).toEqual({ x: 300, y: 200, scale: 0.5 })
  })

  test('arrives, and two small steps are one large one', () => {
    const start = { x: 0, y: 0, scale: 2 }
    const target = { x: 100, y: 50, scale: 2 }
    const twice = follow(follow(start, target, 0.1), target, 0.1)
    expect(twice.x).toBeCloseTo(follow(start, target, 0.2).x, 9)
    expect(follow(start, target, 0.35).x).toBeCloseTo(63.212, 3)
    expect(follow(start, target, 5)).toBe(target)
  })

  test('the scale bar is a round length of at most 140 px', () => {
    expect([0.9, 1.3, 2.6, 3.2, 6].map(scaleBar)).toEqual([100, 100, 50, 20, 20])
  })
})
