import fc from 'fast-check'
import { describe, expect, it, test } from 'vitest'
import { cardConfig } from '../configs.ts'
import { arrived, setMotor, startMove } from '../index.ts'
import { pose, robotAt, run, start } from '../testing/worlds.ts'
import type { MotorPlug, RobotConfig } from '../types.ts'
import { motorAt, motorPorts, withMotor, withWheel } from './plugged.ts'

const bare: RobotConfig = { ...cardConfig, sensors: {} }
const reversed: MotorPlug = { kind: 'large', reversed: true }

function moved(config: RobotConfig, left: number, right: number, degrees?: number) {
  const robot = { ...robotAt(pose(1000, 1000)), config }
  const sim = start({ size: { width: 2000, height: 2000 }, robots: [robot] })
  startMove(sim, 0, { left, right, ...(degrees !== undefined && { degrees }) })
  if (degrees === undefined) run(sim, 60)
  else for (let tick = 0; tick < 600 && !arrived(sim, 0); tick++) run(sim, 1)
  const { x, y, heading } = sim.state.robots[0]!
  return { x: x - 1000, y: y - 1000, turn: (heading * 180) / Math.PI }
}
const degreesFor = (cm: number, diameter = 5.6) => (cm / (Math.PI * diameter)) * 360

describe('a left motor that turns backwards', () => {
  const back = withMotor(bare, 'C', reversed)

  test('the robot drives backwards instead of forwards, with and without a distance', () => {
    expect(moved(back, 30, 30).x).toBeCloseTo(-moved(bare, 30, 30).x, 9)
    expect(moved(back, 30, 30, degreesFor(20)).x).toBeCloseTo(-20, 9)
  })

  test('it turns the other way round, as far', () => {
    expect(moved(back, 30, -30, 200).turn).toBeCloseTo(-moved(bare, 30, -30, 200).turn, 9)
  })

  test('it drives its curve backwards', () => {
    const curve = moved(back, 10, 30, 500)
    const ahead = moved(bare, -10, -30, 500)
    expect(curve).toEqual(ahead)
  })

  test('a motor alone turns as it is told', () => {
    const sim = start({ robots: [{ ...robotAt(pose(200, 200)), config: back }] })
    setMotor(sim, 0, 'C', 50)
    run(sim, 1)
    expect(sim.state.robots[0]!.motors.C.turned).toBeGreaterThan(0)
  })
})

test('a right motor that turns backwards, a regulation, other motors: the way is the same', () => {
  const others = withMotor(withMotor(bare, 'B', reversed), 'A', { kind: 'medium', reversed: true })
  const unregulated = withMotor(others, 'C', { kind: 'large', unregulated: true })
  expect(moved(unregulated, 10, 30, 500)).toEqual(moved(bare, 10, 30, 500))
})

test('twice as large wheels go twice as far at a power, wheels twice as far apart turn half as much', () => {
  const { wheelDiameter, trackWidth } = bare
  expect(moved({ ...bare, wheelDiameter: wheelDiameter * 2 }, 30, 30).x).toBeCloseTo(
    2 * moved(bare, 30, 30).x,
    9,
  )
  expect(moved({ ...bare, trackWidth: trackWidth * 2 }, 30, -30, 300).turn).toBeCloseTo(
    moved(bare, 30, -30, 300).turn / 2,
    9,
  )
})

describe('what is plugged in', () => {
  const plug = fc.option(
    fc.record({ kind: fc.constantFrom('large' as const, 'medium' as const, 'other' as const) }),
    { nil: undefined },
  )
  const port = fc.constantFrom(...motorPorts)

  it('is at its port, and the other ports have what they had', () => {
    fc.assert(
      fc.property(port, plug, port, plug, (first, one, second, two) => {
        const before = withMotor(bare, first, one)
        const after = withMotor(before, second, two)
        expect(motorAt(after, second)?.kind).toBe(two?.kind)
        for (const other of motorPorts)
          if (other !== second) expect(motorAt(after, other)).toEqual(motorAt(before, other))
      }),
      { seed: 7 },
    )
  })

  it('is not said where it is the usual', () => {
    expect(withMotor(withMotor(bare, 'C', reversed), 'C', { kind: 'large' })).toEqual(bare)
  })

  it('wheels change motors', () => {
    expect(withWheel(bare, 'B', 'left').drive).toEqual({ left: 'B', right: 'C' })
    const third = withWheel(withMotor(bare, 'A', { kind: 'large' }), 'A', 'left')
    expect(third.drive).toEqual({ left: 'A', right: 'B' })
    expect(motorAt(third, 'C')).toEqual({ kind: 'large' })
  })
})
