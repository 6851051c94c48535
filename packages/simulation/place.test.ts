import { timed } from '@botgarten/numbers/testing/processor'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { startMove } from './index.ts'
import { hashOf, overlapBy, pose, robotAt, run, square, start, thing } from './testing/worlds.ts'

const crates = () => ({
  obstacles: [
    thing('square', square(50), pose(300, 200)),
    thing('wall', { kind: 'rectangle', width: 100, height: 10 }, pose(300, 300)),
    thing('crate', square(30), pose(450, 200), false),
  ],
})

describe('placing by hand', () => {
  test('a robot comes to stand where it is put', () => {
    const sim = start(crates())
    expect(sim.place('bo', pose(50, 60, 90))).toEqual(pose(50, 60, 90))
    expect(sim.state.robots[0]).toMatchObject({ x: 50, y: 60, heading: Math.PI / 2 })
  })

  test('a fixed thing that is dropped on the robot comes to lie beside it, and the robot stays', () => {
    const sim = start(crates())
    const { x, y } = sim.place('square', pose(100, 200))
    expect(sim.state.robots[0]).toMatchObject({ x: 100, y: 200, heading: 0 })
    expect(overlapBy(sim, 0)).toBe(false)
    // The robot reaches 10.4 cm to its sides: no nearer place is farther than that and half the square.
    expect(Math.sqrt((x - 100) ** 2 + (y - 200) ** 2)).toBeLessThan(25 + 10.4 + 0.6)
    run(sim, 120, () => startMove(sim, 0, { left: 50, right: 50 }))
    expect(overlapBy(sim, 0.1)).toBe(false)
  })

  test('a robot that is dropped on a thing comes to stand beside it', () => {
    const sim = start(crates())
    sim.place('bo', pose(300, 200, 45))
    expect(overlapBy(sim, 0)).toBe(false)
    expect(sim.state.obstacles[0]).toMatchObject({ x: 300, y: 200 })
  })

  test('what is put outside comes to lie on the floor', () => {
    const sim = start(crates())
    expect(sim.place('crate', pose(-500, 900)).x).toBeCloseTo(15, 0)
    expect(sim.place('bo', pose(1e9, -1e9, 180)).y).toBeCloseTo(10.4, 0)
    run(sim, 1)
  })

  test('fixed things may overlap each other: walls meet at corners', () => {
    const sim = start(crates())
    expect(sim.place('wall', pose(300, 220))).toEqual(pose(300, 220))
  })

  test('where there is no free place it stays where it was, and nothing flies apart', () => {
    const sim = start({
      size: { width: 40, height: 40 },
      obstacles: [thing('big', square(30), pose(20, 20))],
      robots: [robotAt(pose(20, 20))],
    })
    expect(sim.place('big', pose(12, 20))).toEqual(pose(20, 20))
    run(sim, 300, () => startMove(sim, 0, { left: 100, right: 60 }))
  })

  test('a thing that is taken into the hand stands still and touches nobody', () => {
    const sim = start({ obstacles: [thing('crate', square(30), pose(130, 200), false)] })
    run(sim, 60, () => startMove(sim, 0, { left: 50, right: 50 }))
    expect(sim.state.robots[0]!.touching).toEqual(['crate'])
    sim.place('crate', pose(300, 300))
    expect(sim.state.robots[0]!.touching).toEqual([])
    run(sim, 60, () => startMove(sim, 0, { left: 0, right: 0 }))
    expect(sim.state.obstacles[0]).toMatchObject({ x: 300, y: 300, vx: 0, vy: 0, spin: 0 })
  })

  test.each([
    ['nobody', pose(10, 10)],
    ['bo', pose(NaN, 10)],
    ['bo', pose(10, 10, Infinity)],
  ])('placing %s at a place that is none changes nothing', (id, at) => {
    const sim = start(crates())
    const before = hashOf(sim)
    sim.place(id, at)
    expect(hashOf(sim)).toBe(before)
  })

  test('sensors see a moved thing at once', () => {
    const sim = start({ ...crates(), robots: [robotAt(pose(100, 196))] })
    expect(sim.read(0, '3', 'distance')).not.toBe(0)
    sim.place('square', pose(140, 196))
    expect(sim.read(0, '3', 'distance')).toBeLessThan(6)
  })

  test('dropping anything anywhere while the robots drive leaves all in order', () => {
    const anywhere = fc.record({
      id: fc.constantFrom('bo', 'square', 'wall', 'crate'),
      x: fc.integer({ min: -50, max: 650 }),
      y: fc.integer({ min: -50, max: 450 }),
      heading: fc.integer({ min: -720, max: 720 }),
    })
    fc.assert(
      fc.property(fc.array(anywhere, { maxLength: 12 }), (drops) => {
        const sim = start(crates())
        for (const { id, x, y, heading } of drops) {
          sim.place(id, { x, y, heading })
          expect(overlapBy(sim, 0.02)).toBe(false)
          run(sim, 40, () => startMove(sim, 0, { left: 80, right: 60 }))
        }
      }),
      { numRuns: 60, seed: 9 },
    )
  })
})

test('a robot that starts inside a thing is put at the nearest free place', () => {
  const sim = start({ ...crates(), robots: [robotAt(pose(310, 210))] })
  expect(overlapBy(sim, 0)).toBe(false)
})

test('things that start edge to edge stay where they are', () => {
  const obstacles = [
    thing('a', square(30), pose(200, 100), false),
    thing('b', square(30), pose(230, 100), false),
  ]
  const sim = start({ obstacles })
  expect(sim.state.obstacles.map(({ x }) => x)).toEqual([200, 230])
})

describe('settling a world that was changed', () => {
  test('what stands off the floor comes back onto it, fixed or not', () => {
    const sim = start(crates())
    sim.restore({
      ...sim.keyframe(),
      robots: [{ ...sim.keyframe().robots[0]!, x: 900 }],
      obstacles: sim.keyframe().obstacles.map((one) => ({ ...one, y: 700 })),
    })
    sim.settle()
    expect(sim.state.robots[0]!.x).toBeLessThan(600)
    for (const { y } of sim.state.obstacles) expect(y).toBeLessThan(400)
    expect(overlapBy(sim, 0.06)).toBe(false)
    run(sim, 60)
  })

  test('what stands well stays, to the last bit', () => {
    const sim = start(crates())
    run(sim, 60, () => startMove(sim, 0, { left: 80, right: 60 }))
    const before = hashOf(sim)
    sim.settle()
    expect(hashOf(sim)).toBe(before)
  })

  test('a hundred movable things inside each other spread out and stay calm', () => {
    const obstacles = Array.from({ length: 100 }, (_, index) =>
      thing(`crate${index}`, square(20), pose(300, 200, index), false),
    )
    const sim = start({ obstacles })
    expect(overlapBy(sim, 0.06)).toBe(false)
    run(sim, 60, () => startMove(sim, 0, { left: 100, right: 100 }))
  })

  test('a hundred things that cannot have a place do not keep anybody waiting', () => {
    const obstacles = Array.from({ length: 100 }, (_, index) =>
      thing(`block${index}`, square(300), pose(300, 200), index % 2 === 0),
    )
    const { result: sim, seconds } = timed(() => {
      const sim = start({ obstacles })
      for (let tick = 0; tick < 10; tick++) sim.step()
      return sim
    })
    expect(seconds).toBeLessThan(10)
    expect(Number.isFinite(sim.state.robots[0]!.x)).toBe(true)
  })
})
