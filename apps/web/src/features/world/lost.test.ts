import type { RobotView } from '@botgarten/lab'
import { describe, expect, test } from 'vitest'
import { follow, lostRobot, type Traces } from './lost.ts'

const size = { width: 300, height: 200 }
const robot = (parts: Partial<RobotView> = {}) =>
  ({
    ...{ id: 'bo', pose: { x: 100, y: 100, heading: 90 }, motors: { B: 50, C: 50 }, touching: ['wall'] },
    ...parts,
  }) as RobotView

/** Seconds after which the robot is lost, watched ten times a second; null: not within ten. */
function lostAfter(at: (seconds: number) => RobotView): number | null {
  let traces: Traces = new Map()
  for (let tenth = 0; tenth <= 100; tenth++) {
    const view = { robots: [at(tenth / 10)], seconds: tenth / 10 }
    traces = follow(traces, view)
    if (lostRobot(traces, view, size) !== null) return tenth / 10
  }
  return null
}

describe('a robot is lost', () => {
  test('when it has pushed against a thing for three seconds without getting anywhere', () => {
    expect(lostAfter(() => robot())).toBe(3)
  })

  test('also when it trembles, and when its heading trembles over 0 degrees', () => {
    const shake = (s: number) => (Math.round(s * 10) % 2 ? 0.4 : -0.4)
    expect(
      lostAfter((s) => robot({ pose: { x: 100 + shake(s), y: 100, heading: (360 + shake(s)) % 360 } })),
    ).toBe(3)
  })

  test('at once when it is off the floor or nowhere at all', () => {
    expect(lostAfter(() => robot({ pose: { x: 301, y: 5, heading: 0 } }))).toBe(0)
    expect(lostAfter(() => robot({ pose: { x: 10, y: -1, heading: 0 } }))).toBe(0)
    expect(lostAfter(() => robot({ pose: { x: NaN, y: 5, heading: 0 } }))).toBe(0)
  })
})

describe('a robot is not lost', () => {
  test.each([
    ['when it drives', (s: number) => robot({ pose: { x: 100 + 5 * s, y: 100, heading: 0 } })],
    [
      'when it turns on the spot',
      (s: number) => robot({ pose: { x: 100, y: 100, heading: (s * 40) % 360 } }),
    ],
    ['when its motors stand', () => robot({ motors: { B: 0, C: 1 } })],
    ['when it touches nothing', () => robot({ touching: [] })],
    ['when it backs off in time', (s: number) => robot({ touching: s % 2 < 1.9 ? ['wall'] : [] })],
  ] as const)('%s', (_, at) => {
    expect(lostAfter(at)).toBeNull()
  })

  test('when time has gone back', () => {
    const late = { robots: [robot()], seconds: 8 }
    const early = { robots: [robot()], seconds: 2 }
    expect(lostRobot(follow(follow(new Map(), late), early), early, size)).toBeNull()
  })
})

test('what has not changed is the same map', () => {
  const view = { robots: [robot()], seconds: 1 }
  const traces = follow(new Map(), view)
  expect(follow(traces, { ...view, seconds: 2 })).toBe(traces)
})
