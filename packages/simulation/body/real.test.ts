import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { cardConfig } from '../configs.ts'
import { arrived, freshRobot, rollsOn, startMove, stopMotors } from '../index.ts'
import { hashOf, pose, robotAt, run, square, start, thing } from '../testing/worlds.ts'
import type { RobotConfig } from '../types.ts'

const wall = thing('wall', square(100), pose(450, 200))
const robotWith = (config: Partial<RobotConfig>, obstacles = [wall]) =>
  start({ robots: [robotAt(pose(100, 200), { ...cardConfig, ...config })], obstacles })

/** x and distance tick by tick, told to drive at 50 percent from tick 0 on. */
function drive(config: Partial<RobotConfig>, ticks: number) {
  const sim = robotWith(config)
  const trail: { x: number; distance: number }[] = []
  startMove(sim, 0, { left: 50, right: 50 })
  run(sim, ticks, () =>
    trail.push({ x: sim.state.robots[0]!.x, distance: Number(sim.read(0, '2', 'distance')) }),
  )
  return trail
}

describe('a robot with delay', () => {
  test.each([1, 7, 60])('of %s ticks drives the same way that much later', (delay) => {
    const prompt = drive({}, 100)
    const late = drive({ delay }, 100 + delay)
    expect(late.slice(0, delay).map(({ x }) => x)).toEqual(Array.from({ length: delay }, () => 100))
    expect(late.slice(delay).map(({ x }) => x)).toEqual(prompt.map(({ x }) => x))
  })

  test.each([1, 7, 60])('of %s ticks reads what was seen that much earlier', (delay) => {
    const sim = robotWith({ delay })
    const watched = robotWith({ delay })
    const true_: number[] = []
    startMove(sim, 0, { left: 50, right: 50 })
    startMove(watched, 0, { left: 50, right: 50 })
    run(sim, 150, (tick) => {
      // The rays are not late: they are what is there.
      true_.push(Math.min(...watched.rays(0, '2').map(({ distance }) => distance)))
      expect(sim.read(0, '2', 'distance')).toBe(true_[Math.max(0, tick - delay)])
      watched.step()
    })
  })

  test('turns its encoders when its motors turn, and its moves still end where they should', () => {
    const sim = robotWith({ delay: 20 }, [])
    const degrees = (100 / (Math.PI * 5.6)) * 360
    startMove(sim, 0, { left: 60, right: 60, degrees })
    run(sim, 20)
    expect(sim.state.robots[0]!.motors.B.turned).toBe(0)
    run(sim, 400)
    expect(arrived(sim, 0)).toBe(true)
    expect(sim.state.robots[0]!.x).toBeCloseTo(200, 6)
    expect(sim.state.robots[0]!.motors.B.turned).toBeCloseTo(degrees, 6)
  })

  test('rolls on after Stop until the order has arrived, and until what it sees has', () => {
    const sim = robotWith({ delay: 12 })
    startMove(sim, 0, { left: 50, right: 50 })
    run(sim, 30)
    stopMotors(sim, 0)
    const ticks = Array.from({ length: 100 }, () => rollsOn(sim.state.robots[0]!) && (sim.step(), true))
    expect(ticks.filter(Boolean)).toHaveLength(24)
    const nearest = Math.min(...sim.rays(0, '2').map(({ distance }) => distance))
    expect(sim.read(0, '2', 'distance')).toBe(nearest)
  })

  test('begins a run with nothing on its way', () => {
    const sim = robotWith({ delay: 12 })
    startMove(sim, 0, { left: 50, right: 50 })
    run(sim, 30)
    stopMotors(sim, 0)
    freshRobot(sim.state.robots[0]!)
    const { x } = sim.state.robots[0]!
    run(sim, 30)
    expect(sim.state.robots[0]!.x).toBe(x)
  })

  test('sees at once what a hand moves', () => {
    const sim = robotWith({ delay: 30 })
    run(sim, 40)
    sim.place('wall', pose(300, 200))
    const nearest = Math.min(...sim.rays(0, '2').map(({ distance }) => distance))
    expect(sim.read(0, '2', 'distance')).toBe(nearest)
  })
})

describe('unequal motors', () => {
  test('make straight ahead a circle: the weaker wheel goes its share of the way', () => {
    const sim = robotWith({ strength: { left: 1, right: 0.8 } }, [])
    startMove(sim, 0, { left: 50, right: 50 })
    run(sim, 60)
    const { motors, heading } = sim.state.robots[0]!
    expect(motors.C.turned).toBeCloseTo(360, 9)
    expect(motors.B.turned).toBeCloseTo(288, 9)
    const way = (degrees: number) => (degrees / 360) * Math.PI * 5.6
    expect(heading).toBeCloseTo((way(288) - way(360)) / 18, 9)
  })

  test('end a move when the faster wheel has gone its way', () => {
    for (const strength of [
      { left: 0.7, right: 1 },
      { left: 1, right: 0.7 },
      { left: 0.5, right: 0.5 },
    ]) {
      const sim = robotWith({ strength }, [])
      startMove(sim, 0, { left: 50, right: 50, degrees: 500 })
      run(sim, 400)
      expect(arrived(sim, 0)).toBe(true)
      const { B, C } = sim.state.robots[0]!.motors
      expect(Math.max(B.turned, C.turned)).toBeCloseTo(500, 6)
    }
  })
})

test('equally strong and prompt is what it was: not a bit of a run changes', () => {
  const plain = robotWith({})
  const told = robotWith({ delay: 0, noise: 0, strength: { left: 1, right: 1 } })
  for (const sim of [plain, told]) {
    startMove(sim, 0, { left: 63, right: 57, degrees: 2000 })
    run(sim, 600)
  }
  expect(hashOf(told)).toBe(hashOf(plain))
})

test('a robot with delay, noise and unequal motors goes on from any keyframe bit for bit (rule 8)', () => {
  const config = fc.record({
    delay: fc.integer({ min: 0, max: 30 }),
    noise: fc.integer({ min: 0, max: 30 }),
    strength: fc.record({
      left: fc.double({ min: 0.5, max: 1, noNaN: true }),
      right: fc.double({ min: 0.5, max: 1, noNaN: true }),
    }),
  })
  const orders = fc.array(
    fc.tuple(fc.integer({ min: -100, max: 100 }), fc.integer({ min: -100, max: 100 })),
    {
      minLength: 1,
      maxLength: 6,
    },
  )
  fc.assert(
    fc.property(config, orders, fc.integer({ min: 0, max: 150 }), (real, wishes, at) => {
      const ride = (sim: ReturnType<typeof robotWith>, from: number, to: number) => {
        const seen: unknown[] = []
        for (let tick = from; tick < to; tick++) {
          const [left, right] = wishes[Math.floor(tick / 30) % wishes.length]!
          if (tick % 30 === 0) startMove(sim, 0, { left, right })
          seen.push(sim.read(0, '2', 'distance'), sim.read(0, '1', 'light'))
          sim.step()
        }
        return [seen, hashOf(sim)]
      }
      const sim = robotWith(real)
      ride(sim, 0, at)
      const keyframe = structuredClone(sim.keyframe())
      const first = ride(sim, at, 200)
      const other = robotWith(real)
      other.restore(keyframe)
      expect(ride(other, at, 200)).toEqual(first)
    }),
    { numRuns: 40 },
  )
})
