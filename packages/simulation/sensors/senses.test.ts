import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { defaultConfig } from '../configs.ts'
import {
  encoder,
  isPressed,
  pressKey,
  resetEncoder,
  resetGyro,
  resetTimer,
  setMotor,
  startMove,
  timer,
  tone,
} from '../index.ts'
import { pose, robotAt, run, square, start, thing } from '../testing/worlds.ts'
import type { Pose, RobotConfig, SensorKind, SensorPlace, Shape } from '../types.ts'

const place = (kind: SensorKind, x = 0, angle = 0): SensorPlace => ({ kind, x, y: 0, angle })
const withOne = (sensor: SensorPlace): RobotConfig => ({ ...defaultConfig, sensors: { '1': sensor } })
const alone = (sensor: SensorPlace, at: Pose = pose(300, 200)) => ({ robots: [robotAt(at, withOne(sensor))] })
const turnRight = (sim: ReturnType<typeof start>, degrees: number) => {
  startMove(sim, 0, { left: 50, right: -50, degrees: (degrees * 18) / 5.6 })
  run(sim, 400)
}

test('out of the box: touch at port 1, gyro at 2, colour at 3, ultrasonic at 4', () => {
  const kinds = Object.entries(defaultConfig.sensors).map(([port, { kind }]) => [port, kind])
  expect(kinds).toEqual([
    ['1', 'touch'],
    ['2', 'gyro'],
    ['3', 'colour'],
    ['4', 'ultrasonic'],
  ])
})

describe('the bumper', () => {
  const bumper = place('touch', 10)
  const rear = place('touch', -6.7, 180)

  test('is pressed by what the front runs into, fixed or movable, and free again when it backs off', () => {
    for (const fixed of [true, false]) {
      const sim = start({ ...alone(bumper), obstacles: [thing('box', square(30), pose(340, 200), fixed)] })
      expect(sim.read(0, '1', 'touch')).toBe(0)
      run(sim, 60, () => startMove(sim, 0, { left: 60, right: 60 }))
      expect(sim.read(0, '1', 'touch')).toBe(1)
      run(sim, 60, () => startMove(sim, 0, { left: -60, right: -60 }))
      expect(sim.read(0, '1', 'touch')).toBe(0)
    }
  })

  test('is pressed by the edge of the floor and by another robot', () => {
    const edge = start(alone(bumper, pose(560, 200)))
    run(edge, 120, () => startMove(edge, 0, { left: 60, right: 60 }))
    expect(edge.read(0, '1', 'touch')).toBe(1)
    const robots = [robotAt(pose(300, 200), withOne(bumper)), robotAt(pose(340, 200), defaultConfig, 'two')]
    const two = start({ robots })
    run(two, 80, () => startMove(two, 0, { left: 60, right: 60 }))
    expect(two.read(0, '1', 'touch')).toBe(1)
  })

  test('is not pressed by what touches a side or the back', () => {
    const sim = start({ ...alone(bumper), obstacles: [thing('box', square(30), pose(260, 200))] })
    run(sim, 60, () => startMove(sim, 0, { left: -60, right: -60 }))
    expect(sim.state.robots[0]!.touching).toContain('box')
    expect(sim.read(0, '1', 'touch')).toBe(0)
    sim.place('bo', pose(260 + 15 + 10.5, 200, 90))
    expect(sim.read(0, '1', 'touch')).toBe(0)
  })

  test('behind is pressed from behind', () => {
    const sim = start({ ...alone(rear), obstacles: [thing('box', square(30), pose(260, 200))] })
    run(sim, 60, () => startMove(sim, 0, { left: -60, right: -60 }))
    expect(sim.read(0, '1', 'touch')).toBe(1)
  })

  test('agrees with a naive sampling of its bar, for shapes anywhere in front of it', () => {
    const shape = fc.oneof(
      fc.record({ kind: fc.constant('circle' as const), radius: fc.integer({ min: 2, max: 12 }) }),
      fc.record({
        kind: fc.constantFrom('rectangle' as const, 'triangle' as const),
        width: fc.integer({ min: 4, max: 24 }),
        height: fc.integer({ min: 4, max: 24 }),
      }),
    )
    const near = fc.record({
      x: fc.double({ min: 312, max: 322, noNaN: true }),
      y: fc.double({ min: 190, max: 210, noNaN: true }),
      heading: fc.integer({ min: 0, max: 359 }),
    })
    const anyTurn = fc.integer({ min: 0, max: 359 })
    fc.assert(
      fc.property(shape, near, anyTurn, (form: Shape, ahead, turn) => {
        const at = turnedRound(ahead, pose(300, 200), turn)
        const sim = start({ ...alone(bumper, pose(300, 200, turn)), obstacles: [thing('it', form, at)] })
        const { x, y, heading } = sim.state.robots[0]!
        const [inner, outer] = [
          barHits(form, at, 0.1, { x, y, heading }),
          barHits(form, at, 0.2, { x, y, heading }),
        ]
        const read = sim.read(0, '1', 'touch') === 1
        if (inner) expect(read).toBe(true)
        if (!outer) expect(read).toBe(false)
      }),
      { numRuns: 300 },
    )
  })
})

function turnedRound({ x, y, heading }: Pose, centre: Pose, degrees: number): Pose {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)]
  const [dx, dy] = [x - centre.x, y - centre.y]
  return pose(centre.x + c * dx - s * dy, centre.y + s * dx + c * dy, heading + degrees)
}

/** Is one of many points of a bar across the front, so deep, inside the shape? */
function barHits(
  shape: Shape,
  at: Pose,
  depth: number,
  robot: { x: number; y: number; heading: number },
): boolean {
  const [c, s] = [Math.cos(robot.heading), Math.sin(robot.heading)]
  const turned = (at.heading * Math.PI) / 180
  // Half a millimetre of leeway at the ends of the bar, as in its depth.
  const reach = depth < 0.15 ? 5.95 : 6.05
  for (let along = -reach; along <= reach; along += 0.01)
    for (const ahead of [10 - depth, 10, 10 + depth]) {
      const x = robot.x + c * ahead - s * along - at.x
      const y = robot.y + s * ahead + c * along - at.y
      const [dx, dy] = [
        Math.cos(turned) * x + Math.sin(turned) * y,
        Math.cos(turned) * y - Math.sin(turned) * x,
      ]
      if (holds(shape, dx, dy)) return true
    }
  return false
}

function holds(shape: Shape, x: number, y: number): boolean {
  if (shape.kind === 'circle') return x * x + y * y <= shape.radius * shape.radius
  const [halfWidth, halfHeight] = [shape.width / 2, shape.height / 2]
  if (Math.abs(x) > halfWidth || Math.abs(y) > halfHeight) return false
  return shape.kind === 'rectangle' || Math.abs(x) <= (halfWidth * (halfHeight - y)) / shape.height
}

describe('the gyro', () => {
  test('counts degrees clockwise from Start, whole turns too', () => {
    const sim = start(alone(place('gyro'), pose(300, 200, 77)))
    expect(sim.read(0, '1', 'angle')).toBe(0)
    turnRight(sim, 90)
    expect(sim.read(0, '1', 'angle')).toBeCloseTo(90, 6)
    turnRight(sim, 450)
    expect(sim.read(0, '1', 'angle')).toBeCloseTo(540, 6)
    turnRight(sim, -540)
    expect(sim.read(0, '1', 'angle')).toBeCloseTo(0, 6)
  })

  test('counts from where it is set back, each port by itself', () => {
    const sim = start({
      robots: [
        robotAt(pose(300, 200), { ...defaultConfig, sensors: { '1': place('gyro'), '4': place('gyro') } }),
      ],
    })
    turnRight(sim, 90)
    resetGyro(sim, 0, '4')
    turnRight(sim, 30)
    expect(sim.read(0, '1', 'angle')).toBeCloseTo(120, 6)
    expect(sim.read(0, '4', 'angle')).toBeCloseTo(30, 6)
  })

  test('gives the rate in degrees a second: wheels at ±25 % turn the body by 2 · 0.25 · 2 · 5.6π / 18', () => {
    const sim = start(alone(place('gyro')))
    startMove(sim, 0, { left: 25, right: -25 })
    run(sim, 10)
    const radians = (2 * 0.25 * 2 * 5.6 * Math.PI) / 18
    expect(sim.read(0, '1', 'rate')).toBeCloseTo((radians * 180) / Math.PI, 6)
    startMove(sim, 0, { left: 0, right: 0 })
    run(sim, 1)
    expect(sim.read(0, '1', 'rate')).toBe(0)
  })

  test('feels a hand that turns it, but no rate of it', () => {
    const sim = start(alone(place('gyro')))
    sim.place('bo', pose(300, 200, -45))
    expect(sim.read(0, '1', 'angle')).toBeCloseTo(45, 9)
    expect(sim.read(0, '1', 'rate')).toBe(0)
  })
})

describe('infrared', () => {
  test.each([
    [7, 10],
    [35, 50],
    [63, 90],
    [70, 100],
    [200, 100],
  ])('%s cm ahead is %s', (distance, reading) => {
    const wall = thing('wall', square(20), pose(310 + distance + 10, 200))
    const sim = start({ ...alone(place('infrared', 10)), obstacles: [wall] })
    sim.place('bo', pose(300, 200))
    // What is put down by hand keeps a twentieth of a centimetre.
    expect(Math.abs(Number(sim.read(0, '1', 'infrared')) - reading)).toBeLessThan(0.1)
    expect(sim.rays(0, '1').every((ray) => ray.distance <= 70)).toBe(true)
  })
})

describe('the compass', () => {
  test.each([
    [90, 0],
    [0, 90],
    [-90, 180],
    [180, 270],
    [91, 359],
  ])('heading %s is %s clockwise from up', (heading, reading) => {
    expect(start(alone(place('compass'), pose(300, 200, heading))).read(0, '1', 'compass')).toBeCloseTo(
      reading,
      9,
    )
  })
})

describe('the position sensor', () => {
  test('says where the middle of the axle is and where it heads (rule 1), wherever it sits', () => {
    const sim = start(alone(place('position', 5), pose(123.5, 45.25, -30)))
    expect(['x', 'y', 'heading'].map((mode) => sim.read(0, '1', mode as 'x'))).toEqual([
      123.5,
      45.25,
      expect.closeTo(330, 9),
    ])
  })
})

describe('sound', () => {
  test('is 0 in silence, 100 beside its own speaker, half at 20 cm from another robot', () => {
    const robots = [
      robotAt(pose(100, 200), withOne(place('sound'))),
      robotAt(pose(180, 200), defaultConfig, 'two'),
    ]
    const sim = start({ robots })
    expect(sim.read(0, '1', 'sound')).toBe(0)
    tone(sim, 1, 440, null)
    run(sim, 1)
    // 80 cm away: 100 · 20 / (20 + 80).
    expect(sim.read(0, '1', 'sound')).toBeCloseTo(20, 9)
    tone(sim, 0, 440, null)
    run(sim, 1)
    expect(sim.read(0, '1', 'sound')).toBe(100)
  })
})

describe('encoders', () => {
  test('count the degrees of each motor, and from 0 where they are set back', () => {
    const sim = start()
    setMotor(sim, 0, 'A', 50)
    startMove(sim, 0, { left: 100, right: 50 })
    run(sim, 30)
    expect(encoder(sim, 0, 'A')).toBeCloseTo(180, 9)
    expect(encoder(sim, 0, 'C')).toBeCloseTo(360, 9)
    resetEncoder(sim, 0, 'C')
    run(sim, 30)
    expect(encoder(sim, 0, 'C')).toBeCloseTo(360, 9)
    expect(encoder(sim, 0, 'B')).toBeCloseTo(360, 9)
  })
})

describe('timers', () => {
  test('count milliseconds of simulated time, five of them', () => {
    const sim = start()
    run(sim, 90)
    resetTimer(sim, 0, 2)
    run(sim, 31)
    expect([1, 2, 5].map((number) => timer(sim, 0, number))).toEqual([2017, 517, 2017])
    expect([0, 6, 1.5].map((number) => timer(sim, 0, number))).toEqual([null, null, null])
  })
})

describe('keys', () => {
  test('are down until they are let go of; any is any', () => {
    const sim = start()
    expect(isPressed(sim, 0, 'any')).toBe(false)
    pressKey(sim, 0, 'left', true)
    pressKey(sim, 0, 'enter', true)
    pressKey(sim, 0, 'enter', true)
    expect(['left', 'enter', 'up', 'any'].map((key) => isPressed(sim, 0, key as 'up'))).toEqual([
      true,
      true,
      false,
      true,
    ])
    pressKey(sim, 0, 'enter', false)
    expect(isPressed(sim, 0, 'enter')).toBe(false)
    expect(isPressed(sim, 0, 'left')).toBe(true)
  })
})

test('a restored keyframe has all senses as they were, and goes on the same', () => {
  const sensors = {
    '1': place('gyro'),
    '2': place('touch', 10),
    '3': place('compass'),
    '4': place('position'),
  }
  const sim = start({
    robots: [robotAt(pose(300, 200), { ...defaultConfig, sensors })],
    obstacles: [thing('box', square(30), pose(360, 200), false)],
  })
  startMove(sim, 0, { left: 70, right: 68 })
  pressKey(sim, 0, 'up', true)
  run(sim, 50)
  resetGyro(sim, 0, '1')
  resetTimer(sim, 0, 3)
  const keyframe = sim.keyframe()
  const rest = () => {
    const seen: unknown[] = []
    run(sim, 80, () =>
      seen.push(
        sim.read(0, '1', 'angle'),
        sim.read(0, '1', 'rate'),
        sim.read(0, '2', 'touch'),
        sim.read(0, '3', 'compass'),
        sim.read(0, '4', 'y'),
        timer(sim, 0, 3),
        encoder(sim, 0, 'B'),
        isPressed(sim, 0, 'up'),
      ),
    )
    return seen
  }
  const first = rest()
  pressKey(sim, 0, 'up', false)
  sim.restore(keyframe)
  expect(rest()).toEqual(first)
  expect(first).toContain(1)
})
