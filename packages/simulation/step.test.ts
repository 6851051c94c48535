import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { HALF_WIDTH } from './geometry/parts.ts'
import { setMotor, startMove, tone } from './index.ts'
import { hashOf, overlapBy, pose, robotAt, run, square, start, thing } from './testing/worlds.ts'
import type { Obstacle, Simulation } from './types.ts'

const forward =
  (sim: Simulation, percent: number, robot = 0) =>
  () =>
    startMove(sim, robot, { left: percent, right: percent })
const robotOf = (sim: Simulation, robot = 0) => sim.state.robots[robot]!
const thingOf = (sim: Simulation, index = 0) => sim.state.obstacles[index]!

describe('rule 2: a tick', () => {
  test('is a sixtieth of a second', () => {
    const sim = start()
    run(sim, 60, forward(sim, 50))
    expect(sim.state.tick).toBe(60)
    expect(robotOf(sim).x).toBeCloseTo(100 + Math.PI * 5.6, 9)
  })

  test('readings are those after physics, and the same however often and late they are asked for', () => {
    const sim = start({
      obstacles: [thing('wall', square(50), pose(300, 200))],
      robots: [robotAt(pose(100, 196))],
    })
    const asked = start({
      obstacles: [thing('wall', square(50), pose(300, 200))],
      robots: [robotAt(pose(100, 196))],
    })
    run(sim, 100, forward(sim, 30))
    run(asked, 100, () => {
      asked.read(0, '2', 'distance')
      forward(asked, 30)()
      asked.read(0, '2', 'distance')
    })
    expect(asked.read(0, '3', 'distance')).toBe(sim.read(0, '3', 'distance'))
    expect(hashOf(asked)).toBe(hashOf(sim))
  })

  test('a tone ends after its seconds', () => {
    const sim = start()
    tone(sim, 0, 440, 0.5)
    run(sim, 29)
    expect(robotOf(sim).tone?.frequency).toBe(440)
    run(sim, 1)
    expect(robotOf(sim).tone).toBeNull()
  })
})

describe('rule 5: bumping', () => {
  test.each([10, 50, 100])('a robot at power %d stops at a fixed thing, and its encoders go on', (power) => {
    const sim = start({ obstacles: [thing('rock', square(50), pose(180, 200))] })
    run(sim, 1500, forward(sim, power))
    expect(robotOf(sim).x + 10).toBeGreaterThan(154.9)
    expect(robotOf(sim).x + 10).toBeLessThan(155.001)
    expect(robotOf(sim).touching).toEqual(['rock'])
    expect(robotOf(sim).motors.B.turned).toBeCloseTo(1500 * 0.12 * power, 6)
  })

  test.each([0, 90, 180, 270, 37, 200])('a robot heading %d° cannot leave the floor', (heading) => {
    const sim = start({ robots: [robotAt(pose(300, 200, heading))] })
    run(sim, 1200, forward(sim, 100))
    expect(robotOf(sim).touching).toEqual(['edge'])
    const held = pose(robotOf(sim).x, robotOf(sim).y)
    run(sim, 60, forward(sim, 100))
    // A robot that leans against an edge may slide along it to a corner.
    expect(Math.abs(robotOf(sim).x - held.x) * Math.abs(robotOf(sim).y - held.y)).toBeLessThan(0.01)
  })

  test('a robot that backs off touches nothing any more', () => {
    const sim = start({ obstacles: [thing('rock', square(50), pose(150, 200))] })
    run(sim, 100, forward(sim, 50))
    run(sim, 10, forward(sim, -50))
    expect(robotOf(sim).touching).toEqual([])
  })

  test('a thing that is pushed off-centre turns the same, also if another thing comes before it in the list', () => {
    const pushed = thing('pushed', square(30), pose(150, 207))
    const other = thing('other', square(4), pose(20, 20))
    const [alone, behind] = [
      [pushed, other],
      [other, pushed],
    ].map((obstacles) => {
      const sim = start({ obstacles: obstacles.map((one) => ({ ...one, fixed: false })) })
      run(sim, 120, forward(sim, 50))
      return thingOf(sim, obstacles.indexOf(pushed))
    })
    expect(Math.abs(alone!.heading)).toBeGreaterThan(0.01)
    expect(behind).toEqual(alone)
  })

  test('what stands against something goes on touching it', () => {
    const sim = start({ obstacles: [thing('rock', square(50), pose(150, 200))] })
    run(sim, 100, forward(sim, 50))
    run(sim, 100, forward(sim, 0))
    expect(robotOf(sim).touching).toEqual(['rock'])
  })

  test('a movable thing is pushed along, and slides to a halt when the robot stops', () => {
    const sim = start({ obstacles: [thing('crate', square(30), pose(150, 200), false)] })
    run(sim, 240, forward(sim, 50))
    expect(thingOf(sim).x - 25 - robotOf(sim).x).toBeCloseTo(0, 0)
    expect(robotOf(sim).x).toBeGreaterThan(160)
    run(sim, 60, forward(sim, 0))
    const { x } = thingOf(sim)
    expect(thingOf(sim)).toMatchObject({ vx: 0, vy: 0, spin: 0 })
    run(sim, 60, forward(sim, 0))
    expect(thingOf(sim).x).toBe(x)
  })

  test('a thing that is pushed off its middle turns', () => {
    const sim = start({ obstacles: [thing('crate', square(30), pose(150, 214), false)] })
    run(sim, 120, forward(sim, 50))
    expect(thingOf(sim).heading).toBeGreaterThan(0.05)
  })

  test('a pushed thing pushes the next one, and both stop at a wall', () => {
    const crates = [
      thing('a', square(30), pose(150, 200), false),
      thing('b', square(20), pose(180, 200), false),
    ]
    const sim = start({ obstacles: [...crates, thing('wall', square(60), pose(300, 200))] })
    run(sim, 900, forward(sim, 40))
    expect(overlapBy(sim, 0.1)).toBe(false)
    expect(robotOf(sim).x).toBeLessThan(thingOf(sim, 0).x)
    expect(thingOf(sim, 0).x).toBeLessThan(thingOf(sim, 1).x)
    expect(thingOf(sim, 1).x).toBeLessThan(270)
    expect(robotOf(sim).touching).toEqual(['a'])
  })

  test('two robots that meet head-on hold each other', () => {
    const robots = [robotAt(pose(200, 200)), robotAt(pose(300, 200, 180), undefined, 'piep')]
    const sim = start({ robots })
    run(sim, 600, () => {
      forward(sim, 50, 0)()
      forward(sim, 50, 1)()
    })
    expect(robotOf(sim, 1).x - robotOf(sim, 0).x).toBeCloseTo(20, 1)
    expect(robotOf(sim, 0).touching).toEqual(['piep'])
    expect(robotOf(sim, 1).touching).toEqual(['bo'])
  })

  test.each([0, 20, 45, -30])(
    'a slab at the edge, pushed with full power at %d°, is not squeezed',
    (heading) => {
      const slab = thing('slab', { kind: 'rectangle', width: 5, height: 40 }, pose(590, 200), false)
      const sim = start({ obstacles: [slab], robots: [robotAt(pose(565, 200, heading))] })
      run(sim, 600, (tick) => {
        forward(sim, 100)()
        if (tick % 5 === 0) expect(overlapBy(sim, 0.31)).toBe(false)
      })
      const { x, y } = robotOf(sim)
      run(sim, 60, forward(sim, -100))
      expect(Math.abs(robotOf(sim).x - x) + Math.abs(robotOf(sim).y - y)).toBeGreaterThan(25)
    },
  )

  test('wheels stick out: a thing beside the box stops the wheel', () => {
    const post = thing('post', square(4), pose(140, 200 + HALF_WIDTH + 3))
    const sim = start({ obstacles: [post] })
    run(sim, 240, forward(sim, 30))
    expect(robotOf(sim).touching).toContain('post')
  })

  test('any worlds stay in order: random drives of two robots among random things', () => {
    const at = fc.record({
      x: fc.integer({ min: 40, max: 260 }),
      y: fc.integer({ min: 40, max: 160 }),
      heading: fc.integer({ min: 0, max: 359 }),
    })
    const size = fc.integer({ min: 6, max: 40 })
    const shape = fc.oneof(
      fc.record({ kind: fc.constant('rectangle' as const), width: size, height: size }),
      fc.record({ kind: fc.constant('triangle' as const), width: size, height: size }),
      fc.record({ kind: fc.constant('circle' as const), radius: fc.integer({ min: 3, max: 20 }) }),
    )
    const things = fc.array(fc.tuple(shape, at, fc.boolean()), { maxLength: 5 })
    const percent = fc.integer({ min: -100, max: 100 })
    const drives = fc.array(fc.tuple(percent, percent, percent, percent), { minLength: 8, maxLength: 8 })
    fc.assert(
      fc.property(things, at, at, drives, (all, first, second, orders) => {
        const obstacles = all.map(([of, where, fixed], index): Obstacle =>
          thing(`t${index}`, of, where, fixed),
        )
        const robots = [robotAt(first), robotAt(second, undefined, 'piep')]
        const sim = start({ size: { width: 300, height: 200 }, obstacles, robots })
        run(sim, 800, (tick) => {
          const [a, b, c, d] = orders[Math.floor(tick / 100)]!
          startMove(sim, 0, { left: a, right: b })
          startMove(sim, 1, { left: c, right: d })
          if (tick % 10 === 0) expect(overlapBy(sim, 0.31)).toBe(false)
        })
      }),
      { numRuns: 40, seed: 5 },
    )
  })
})

describe('rule 8: keyframes', () => {
  const pushing = () =>
    start({
      obstacles: [
        thing('a', square(30), pose(150, 203, 10), false),
        thing('b', { kind: 'circle', radius: 9 }, pose(182, 196), false),
        thing('c', { kind: 'triangle', width: 30, height: 24 }, pose(230, 210, 40), false),
        thing('wall', square(60), pose(330, 190)),
      ],
      robots: [robotAt(pose(100, 200)), robotAt(pose(420, 195, 180), undefined, 'piep')],
    })
  const drive = (sim: Simulation) => () => {
    const { tick } = sim.state
    startMove(sim, 0, { left: 60, right: 55 + (tick % 7) })
    startMove(sim, 1, { left: tick % 400 < 250 ? 45 : -30, right: 40 })
  }

  test.each([0, 1, 150, 299, 300, 301, 617, 900])(
    'a keyframe at tick %d goes on bit for bit as the original, while things are pushed',
    (ticks) => {
      const original = pushing()
      run(original, ticks, drive(original))
      const keyframe = original.keyframe()
      const trail: string[] = []
      run(original, 1000, () => {
        drive(original)()
        trail.push(hashOf(original))
      })
      const restored = pushing()
      run(restored, 37, drive(restored))
      restored.restore(JSON.parse(JSON.stringify(keyframe)) as typeof keyframe)
      run(restored, 1000, () => {
        drive(restored)()
        expect(hashOf(restored)).toBe(trail[restored.state.tick - ticks])
      })
      expect(restored.state).toEqual(original.state)
      expect(original.state.robots.some(({ touching }) => touching.length > 0)).toBe(true)
    },
  )

  test('taking a keyframe changes nothing, at any tick', () => {
    const plain = pushing()
    const watched = pushing()
    run(plain, 900, drive(plain))
    run(watched, 900, () => {
      watched.keyframe()
      drive(watched)()
    })
    expect(watched.state).toEqual(plain.state)
  })

  test('a keyframe shares nothing with the state', () => {
    const sim = pushing()
    const before = JSON.stringify(sim.state)
    const keyframe = sim.keyframe()
    run(sim, 100, drive(sim))
    expect(JSON.stringify(keyframe)).toBe(before)
    sim.restore(keyframe)
    run(sim, 100, drive(sim))
    expect(JSON.stringify(keyframe)).toBe(before)
  })

  test('whoever holds the state sees the restored one', () => {
    const sim = pushing()
    const { state } = sim
    const keyframe = sim.keyframe()
    run(sim, 10, drive(sim))
    sim.restore(keyframe)
    expect(sim.state).toBe(state)
    expect(state.tick).toBe(0)
  })
})

test('rule 7: two runs of one seed are one run', () => {
  const noisy = () => {
    const robot = robotAt(pose(100, 200, 20))
    const sim = start({ robots: [{ ...robot, config: { ...robot.config, noise: 20 } }] }, 7)
    run(sim, 600, () => setMotor(sim, 0, 'B', Number(sim.read(0, '2', 'distance')) / 3))
    return hashOf(sim)
  }
  expect(noisy()).toBe(noisy())
})
