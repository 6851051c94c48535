import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { cardConfig } from '../configs.ts'
import { arrived, setMotor, startMove, stopMotors } from '../index.ts'
import { pose, robotAt, run, start } from '../testing/worlds.ts'

const robotOf = (sim: ReturnType<typeof start>) => sim.state.robots[0]!
const wide = { size: { width: 2000, height: 2000 }, robots: [robotAt(pose(1000, 1000))] }
/** Degrees of wheel turning for a way in cm, and for a turn on the spot: pi · d a wheel turn. */
const forWay = (cm: number) => (cm / (Math.PI * 5.6)) * 360
const forTurn = (degrees: number) => (degrees * 18) / 5.6

/** Moves and waits until it has ended. */
function move(sim: ReturnType<typeof start>, left: number, right: number, degrees: number): number {
  startMove(sim, 0, { left, right, degrees })
  let ticks = 0
  for (; !arrived(sim, 0); ticks++) run(sim, 1)
  return ticks
}

describe('rule 4: driving', () => {
  test.each([10, 50, 100])('90° at power %d is 90° within 0.5°', (power) => {
    const sim = start(wide)
    move(sim, -power, power, forTurn(90))
    expect(Math.abs((robotOf(sim).heading * 180) / Math.PI - 90)).toBeLessThan(1e-9)
    expect([robotOf(sim).x, robotOf(sim).y]).toEqual([1000, 1000])
  })

  test.each([10, 50, 100])('100 cm at power %d are 100 cm within 0.5 cm', (power) => {
    const sim = start(wide)
    move(sim, power, power, forWay(100))
    expect(Math.abs(robotOf(sim).x - 1100)).toBeLessThan(1e-9)
    expect([robotOf(sim).y, robotOf(sim).heading]).toEqual([1000, 0])
  })

  test('a move ends exactly and takes the time it should, whatever its power and length', () => {
    const percent = fc.double({ min: -100, max: 100, noNaN: true })
    fc.assert(
      fc.property(
        percent,
        percent,
        fc.double({ min: 0.1, max: 900, noNaN: true }),
        (left, right, degrees) => {
          fc.pre(Math.max(Math.abs(left), Math.abs(right)) >= 1)
          const sim = start(wide)
          const ticks = move(sim, left, right, degrees)
          const faster = Math.max(Math.abs(left), Math.abs(right))
          expect(ticks).toBeLessThanOrEqual(Math.ceil(degrees / (faster * 0.12) + 1e-6))
          expect(robotOf(sim).motors.C.turned).toBeCloseTo((degrees * left) / faster, 6)
          expect(robotOf(sim).motors.B.turned).toBeCloseTo((degrees * right) / faster, 6)
          expect(robotOf(sim).motors.B.percent).toBe(0)
        },
      ),
      { numRuns: 60, seed: 4 },
    )
  })

  test('100 percent are two wheel turns a second, from the first tick on', () => {
    const sim = start(wide)
    startMove(sim, 0, { left: 100, right: 100 })
    run(sim, 1)
    expect(robotOf(sim).motors.B.turned).toBeCloseTo(12, 12)
    run(sim, 59)
    expect(robotOf(sim).x - 1000).toBeCloseTo(2 * Math.PI * 5.6, 9)
  })

  test('a curve is a circle round the instantaneous centre, without drift', () => {
    const sim = start(wide)
    // The centre of left 30, right 60 lies 27 cm to the left: 9 · (60 + 30) / (60 − 30).
    startMove(sim, 0, { left: 30, right: 60 })
    run(sim, 5000, () => {
      const { x, y } = robotOf(sim)
      expect(Math.sqrt((x - 1000) ** 2 + (y - 1027) ** 2)).toBeCloseTo(27, 9)
    })
  })

  test('of two writers to a motor in one tick the last wins', () => {
    const sim = start(wide)
    setMotor(sim, 0, 'B', 100)
    setMotor(sim, 0, 'B', 0)
    run(sim, 10)
    expect(robotOf(sim).x).toBe(1000)
  })

  test('a wheel that is set by itself ends the move of both', () => {
    const sim = start(wide)
    startMove(sim, 0, { left: 50, right: 50, degrees: 720 })
    setMotor(sim, 0, 'B', 20)
    expect(arrived(sim, 0)).toBe(true)
    expect(robotOf(sim).motors.C.percent).toBe(0)
    expect(robotOf(sim).motors.B.percent).toBe(20)
  })

  test('negative degrees go backwards', () => {
    const sim = start(wide)
    move(sim, 50, 50, -forWay(20))
    expect(robotOf(sim).x).toBeCloseTo(980, 9)
  })

  test.each([
    [0, 0, 100],
    [50, 50, 0],
    [50, 50, NaN],
    [NaN, NaN, 90],
  ])('a move of %d and %d percent over %d° is over at once', (left, right, degrees) => {
    const sim = start(wide)
    expect(move(sim, left, right, degrees)).toBe(0)
    run(sim, 5)
    expect(robotOf(sim).x).toBe(1000)
  })

  test('speeds are cut to −100 to 100 percent', () => {
    const sim = start(wide)
    startMove(sim, 0, { left: 1e9, right: -Infinity })
    expect([robotOf(sim).motors.C.percent, robotOf(sim).motors.B.percent]).toEqual([100, -100])
  })

  test('motors that drive no wheel turn too, and stopping the wheels does not stop them', () => {
    const sim = start(wide)
    setMotor(sim, 0, 'A', 50)
    stopMotors(sim, 0)
    run(sim, 60)
    expect(robotOf(sim).motors.A.turned).toBeCloseTo(360, 9)
    expect(robotOf(sim).x).toBe(1000)
  })

  test('wheels and track come from the configuration', () => {
    const config = {
      ...cardConfig,
      wheelDiameter: 4,
      trackWidth: 12,
      drive: { left: 'A', right: 'D' },
    } as const
    const sim = start({ ...wide, robots: [robotAt(pose(1000, 1000), config)] })
    startMove(sim, 0, { left: 50, right: -50, degrees: 90 * 3 })
    run(sim, 200)
    expect(robotOf(sim).heading).toBeCloseTo(-Math.PI / 2, 9)
    expect(robotOf(sim).motors.A.turned).toBeCloseTo(270, 9)
  })
})
