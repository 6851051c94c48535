import { describe, expect, test } from 'vitest'
import { cardConfig } from '../configs.ts'
import { COLOURS } from '../floor/colours.ts'
import { startMove, tone } from '../index.ts'
import { hashOf, pose, robotAt, run, square, start, thing } from '../testing/worlds.ts'
import type { RobotConfig, SensorKind, SensorPlace, SensorPort } from '../types.ts'
import { MODES_OF } from './readings.ts'

const withSensors = (sensors: { readonly [port in SensorPort]?: SensorPlace }, noise = 0): RobotConfig => ({
  ...cardConfig,
  sensors,
  noise,
})
const ahead: SensorPlace = { kind: 'ultrasonic', x: 10, y: 0, angle: 0 }
const below: SensorPlace = { kind: 'colour', x: 5, y: 0, angle: 0 }

describe('the distance sensor', () => {
  test('measures from its place at the front edge', () => {
    const robots = [robotAt(pose(100, 200), withSensors({ '4': ahead }))]
    const sim = start({ robots, obstacles: [thing('wall', square(100), pose(250, 200))] })
    expect(sim.read(0, '4', 'distance')).toBeCloseTo(90, 9)
    sim.place('bo', pose(80, 200))
    expect(sim.read(0, '4', 'distance')).toBeCloseTo(110, 9)
  })

  test('sends five rays: 0, ±pi/16, ±pi/8', () => {
    const sim = start({ robots: [robotAt(pose(300, 200, 90), withSensors({ '1': ahead }))] })
    const angles = sim.rays(0, '1').map(({ fromX, fromY, toX, toY }) => Math.atan2(fromX - toX, toY - fromY))
    const wanted = [0, Math.PI / 16, -Math.PI / 16, Math.PI / 8, -Math.PI / 8]
    angles.forEach((angle, ray) => expect(angle).toBeCloseTo(wanted[ray]!, 9))
    expect(sim.rays(0, '1')[0]).toMatchObject({ fromX: 300, fromY: 210 })
  })

  test('reads the nearest hit of its rays, and each ray ends at its own', () => {
    const robots = [robotAt(pose(100, 200), withSensors({ '1': ahead }))]
    // Only the ray at −pi/8 meets the post.
    const post = thing('post', { kind: 'circle', radius: 4 }, pose(110 + 60 * Math.cos(Math.PI / 8), 200 - 60 * Math.sin(Math.PI / 8))) // prettier-ignore
    const sim = start({ robots, obstacles: [post] })
    expect(sim.read(0, '1', 'distance')).toBeCloseTo(56, 9)
    expect(sim.rays(0, '1').map(({ distance }) => Math.round(distance))).toEqual([255, 255, 255, 255, 56])
  })

  test('sees nothing beyond 255 cm, and the edge of the floor within', () => {
    const robots = [robotAt(pose(100, 200), withSensors({ '1': ahead }))]
    const sim = start({ robots })
    expect(sim.read(0, '1', 'distance')).toBe(255)
    sim.place('bo', pose(500, 200))
    expect(sim.read(0, '1', 'distance')).toBeCloseTo(90, 9)
  })

  test('sees other robots, but not its own', () => {
    const config = withSensors({ '1': ahead, '2': { ...ahead, x: -6, angle: 0 } })
    const robots = [robotAt(pose(100, 200), config), robotAt(pose(200, 200), config, 'piep')]
    const sim = start({ robots })
    expect(sim.read(0, '1', 'distance')).toBeCloseTo(83.3, 9)
    expect(sim.read(0, '2', 'distance')).toBeCloseTo(99.3, 9)
    run(sim, 60, () => startMove(sim, 1, { left: 20, right: 20 }))
    expect(sim.read(0, '1', 'distance')).toBeCloseTo(83.3 + 0.4 * Math.PI * 5.6, 9)
  })

  test('reads 0 to a hair when it leans against a thing, moved things included', () => {
    for (const fixed of [true, false]) {
      const robots = [robotAt(pose(100, 200), withSensors({ '1': ahead }))]
      const sim = start({ robots, obstacles: [thing('box', square(30), pose(150, 200), fixed)] })
      run(sim, 200, (tick) => {
        startMove(sim, 0, { left: 60, right: 60 })
        if (tick > 100) expect(sim.read(0, '1', 'distance')).toBeLessThan(0.1)
      })
    }
  })

  test("the cards' two sensors see what is straight ahead", () => {
    const sim = start({ obstacles: [thing('square', square(50), pose(200, 200))] })
    expect(sim.read(0, '2', 'distance')).toBeLessThan(80)
    expect(sim.read(0, '3', 'distance')).toBeCloseTo(Number(sim.read(0, '2', 'distance')), 6)
  })
})

describe('the colour sensor', () => {
  const names = Object.keys(COLOURS) as (keyof typeof COLOURS)[]
  const stripes = names.map((name, index) => ({
    id: name,
    shape: { kind: 'rectangle', width: 30, height: 100 } as const,
    pose: pose(60 + 30 * index, 200),
    colour: COLOURS[name],
  }))

  test('names all eight colours as it drives over them', () => {
    const sim = start({ areas: stripes, robots: [robotAt(pose(55, 200))] })
    const seen = new Set<unknown>()
    run(sim, 420, () => {
      startMove(sim, 0, { left: 100, right: 100 })
      seen.add(sim.read(0, '1', 'colour'))
    })
    for (const name of names) expect(seen, name).toContain(COLOURS[name])
  })

  test('light is the mean of red, green and blue in percent', () => {
    const sim = start({ areas: stripes, robots: [robotAt(pose(60 + 30 * 6 - 5, 200))] })
    // Blue #0057A6.
    const channels = (['red', 'green', 'blue'] as const).map((mode) => sim.read(0, '1', mode))
    expect(channels).toEqual([0x00, 0x57, 0xa6])
    expect(sim.read(0, '1', 'light')).toBeCloseTo(((0x57 + 0xa6) / 3 / 255) * 100, 9)
  })

  test('a mix at an edge has the mean of both sides', () => {
    const areas = [{ ...stripes[0]!, pose: pose(120, 200) }]
    const sim = start({ areas, robots: [robotAt(pose(100, 200))] })
    const light = Number(sim.read(0, '1', 'light'))
    expect(light).toBeGreaterThan(20)
    expect(light).toBeLessThan(80)
  })
})

describe('no sensor, no reading', () => {
  test.each([
    ['4', 'distance'],
    ['4', 'colour'],
    ['1', 'distance'],
    ['2', 'light'],
  ] as const)('port %s, %s', (port, mode) => {
    const sim = start()
    expect(sim.read(0, port, mode)).toBeNull()
    expect(sim.rays(0, port === '4' ? '4' : '1')).toEqual([])
  })
})

describe('noise', () => {
  const noisy = (noise: number) =>
    start({
      robots: [robotAt(pose(100, 200), withSensors({ '1': below, '2': ahead, '3': ahead }, noise))],
      obstacles: [thing('wall', square(100), pose(250, 200))],
    })

  test('multiplies each reading by 1 ± noise percent, evenly', () => {
    const sim = noisy(10)
    const readings: number[] = []
    run(sim, 2000, () => readings.push(Number(sim.read(0, '2', 'distance')) / 90))
    expect(Math.min(...readings)).toBeGreaterThanOrEqual(0.9)
    expect(Math.min(...readings)).toBeLessThan(0.905)
    expect(Math.max(...readings)).toBeLessThanOrEqual(1.1)
    expect(Math.max(...readings)).toBeGreaterThan(1.095)
    const mean = readings.reduce((sum, x) => sum + x, 0) / readings.length
    // Five standard errors of a mean of 2000 uniform draws of ±0.1.
    expect(Math.abs(mean - 1)).toBeLessThan((5 * 0.1) / Math.sqrt(3 * 2000))
  })

  test('is one draw a sensor and tick: reading twice, late or not at all changes nothing', () => {
    const read = noisy(10)
    const unread = noisy(10)
    run(read, 50, () => {
      expect(read.read(0, '2', 'distance')).toBe(read.read(0, '2', 'distance'))
      read.read(0, '3', 'distance')
    })
    run(unread, 50)
    expect(unread.read(0, '2', 'distance')).toBe(read.read(0, '2', 'distance'))
    expect(unread.read(0, '2', 'distance')).not.toBe(unread.read(0, '3', 'distance'))
    expect(unread.state.noise).toEqual(read.state.noise)
  })

  test('a restored keyframe reads the same, now and on', () => {
    const sim = noisy(25)
    run(sim, 77)
    const keyframe = sim.keyframe()
    const readings = () => (['2', '3'] as const).map((port) => sim.read(0, port, 'distance'))
    const trail = () =>
      Array.from({ length: 20 }, () => {
        const now = readings()
        sim.step()
        return now
      })
    const first = trail()
    sim.restore(keyframe)
    expect(trail()).toEqual(first)
  })

  const sensor = (kind: SensorKind): SensorPlace => ({ kind, x: 0, y: 0, angle: 0 })

  test('shifts both coordinates of a place alike, and its heading by as much of half a turn', () => {
    const sim = start({ robots: [robotAt(pose(100, 200, 90), withSensors({ '1': sensor('position') }, 10))] })
    run(sim, 50, () => {
      const read = (mode: 'x' | 'y' | 'heading') => Number(sim.read(0, '1', mode))
      expect(read('y') - 200).toBeCloseTo(read('x') - 100, 9)
      expect(read('heading') - 90).toBeCloseTo(1.8 * (read('x') - 100), 9)
    })
  })

  test('never makes a sound louder than 100', () => {
    const sim = start({ robots: [robotAt(pose(100, 200), withSensors({ '1': sensor('sound') }, 10))] })
    tone(sim, 0, 440, 60)
    const heard: number[] = []
    run(sim, 100, () => heard.push(Number(sim.read(0, '1', 'sound'))))
    expect(Math.max(...heard)).toBe(100)
    expect(Math.min(...heard)).toBeLessThan(100)
  })

  test.each(Object.entries(MODES_OF))('a sensor of kind %s reads each of its modes', (kind, modes) => {
    const sim = start({
      robots: [robotAt(pose(100, 200), withSensors({ '1': sensor(kind as SensorKind) }))],
    })
    for (const mode of modes) expect(sim.read(0, '1', mode), mode).not.toBeNull()
    expect(modes).toHaveLength(kind === 'irseeker' ? 0 : modes.length || 1)
  })

  test('off by default: nothing is drawn', () => {
    const sim = noisy(0)
    const before = [...sim.state.noise]
    run(sim, 10)
    expect(sim.state.noise).toEqual(before)
    expect(sim.read(0, '2', 'distance')).toBeCloseTo(90, 9)
    expect(hashOf(sim)).toBe(hashOf(sim))
  })
})
