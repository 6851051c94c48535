import { cardConfig, type World } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { ProjectError } from './error.ts'
import { inScene, sceneOf } from './scene-world.ts'
import { parseScene, writeScene } from './scene.ts'
import { pathsIn, replaced } from '../testing/paths.ts'

const asset = 'a'.repeat(64)
const pictures = {
  [asset]: { type: 'image/png', base64: 'iVBORw0KGgo=' },
  ['b'.repeat(64)]: { type: 'image/png', base64: 'AAAA' },
} as const

const at = (x: number, y: number, heading = 0) => ({ x, y, heading })
const world: World = {
  size: { width: 300, height: 200 },
  floor: { asset },
  areas: [{ id: 'a', shape: { kind: 'circle', radius: 20 }, pose: at(50, 50), colour: '#F7D117' }],
  lines: [{ id: 'l', points: [{ x: 10, y: 10 }, { x: 90, y: 10 }], width: 3, colour: '#000000' }], // prettier-ignore
  obstacles: [
    {
      ...{ id: 'o', shape: { kind: 'triangle', width: 20, height: 30, tip: 4 }, pose: at(150, 90, 30) },
      ...{ fixed: false, colour: '#0057A6' },
    },
  ],
  robots: [{ id: 'bo', pose: at(100, 100, 90), program: 'main', brain: '', config: cardConfig }],
}

/** As Open Roberta saves it: a square of 100 px at (580, 290), a circle, a triangle, one robot with two poses. */
const foreign = {
  robotPoses: [
    [
      { x: 0.5, y: 0.5, theta: 1 },
      { x: 160 / 750, y: 160 / 480, theta: Math.PI / 2 },
    ],
  ],
  obstacles: [
    { x: 580 / 750, y: 290 / 480, w: 100 / 750, h: 100 / 480, theta: 0, color: '#33b8ca', form: 'RECTANGLE', type: 'OBSTACLE' },
    { x: 0.5, y: 0.5, r: 30 / 480 / 750, color: '#f00', form: 'CIRCLE', type: 'OBSTACLE' },
  ],
  colorAreas: [
    { ax: 100 / 750, ay: 100 / 480, bx: 100 / 750, by: 220 / 480, cx: 190 / 750, cy: 220 / 480, color: '#FBED00', form: 'Triangle', type: 'COLORAREA' },
  ],
  marker: [],
} // prettier-ignore

function reasonOf(data: unknown): string {
  try {
    parseScene(typeof data === 'string' ? data : JSON.stringify(data))
    return 'accepted'
  } catch (error) {
    if (error instanceof ProjectError) return error.reason
    throw error
  }
}

const ours = () => JSON.parse(writeScene(sceneOf(world), pictures)) as { [name: string]: unknown }

describe('a scene file of ours', () => {
  it('holds the world, its start poses and the one picture it needs, and comes back the same', () => {
    const { assets, ...scene } = parseScene(writeScene(sceneOf(world), pictures))
    expect(scene).toEqual(sceneOf(world))
    expect(Object.keys(assets)).toEqual([asset])
  })

  it('put into another world keeps the robots, their programs and their bodies', () => {
    const other: World = {
      ...world,
      floor: { colour: '#FFFFFF' },
      obstacles: [],
      size: { width: 90, height: 80 },
    }
    const next = inScene(other, { ...sceneOf(world), starts: [] })
    expect(next).toEqual(world)
    expect(inScene(other, { ...sceneOf(world), starts: [at(1, 2)] }).robots[0]).toEqual({
      ...world.robots[0],
      pose: at(1, 2),
    })
  })

  it('without its own picture is refused', () => {
    expect(reasonOf({ ...ours(), assets: {} })).toBe('notAScene')
  })
})

describe('a scene file of Open Roberta', () => {
  const scene = parseScene(JSON.stringify(foreign))

  it('3 px are a cm, the border of 10 px is no floor', () => {
    expect(scene.size).toEqual({ width: 243.3, height: 153.3 })
  })

  it('rule 1: y goes up and headings are counter-clockwise; the robot starts at its second pose', () => {
    // 160 px from the left and the top, less the border: 50 cm and 153.33 − 50 cm.
    expect(scene.starts).toEqual([at(50, 103.33, 270)])
  })

  it('a rectangle is known by its upper left corner, a circle by its middle; all are fixed', () => {
    const [square, circle] = scene.obstacles
    expect(square).toMatchObject({ shape: { kind: 'rectangle', width: 33.33, height: 33.33 }, fixed: true })
    // Middle at (630, 340) px.
    expect(square!.pose).toEqual(at(206.67, 43.33))
    expect(circle).toMatchObject({ shape: { kind: 'circle', radius: 10 }, colour: '#FF0000' })
    expect(circle!.pose).toEqual(at(121.67, 76.67))
  })

  it('a triangle keeps its three corners', () => {
    const [area] = scene.areas
    if (area?.shape.kind !== 'triangle') return expect.fail()
    const { width, height, tip = 0 } = area.shape
    const turn = (area.pose.heading * Math.PI) / 180
    const corner = (x: number, y: number) => [
      Math.round(area.pose.x + x * Math.cos(turn) - y * Math.sin(turn)),
      Math.round(area.pose.y + x * Math.sin(turn) + y * Math.cos(turn)),
    ]
    const corners = [
      corner(0 - width / 2, 0 - height / 2),
      corner(width / 2, 0 - height / 2),
      corner(tip, height / 2),
    ]
    // (100, 100), (100, 220), (190, 220) px.
    expect(corners.sort((a, b) => a[0]! - b[0]! || a[1]! - b[1]!)).toEqual([[30, 83], [30, 123], [60, 83]]) // prettier-ignore
  })

  describe('with markers', () => {
    const marked = (...ids: readonly unknown[]) =>
      parseScene(
        JSON.stringify({
          ...foreign,
          marker: ids.map((markerId, k) => ({
            ...{ x: (100 + 60 * k) / 750, y: 100 / 480, w: 36 / 750, h: 36 / 480, theta: 0 },
            ...{ color: '#FBED00', form: 'RECTANGLE', type: 'MARKER', markerId },
          })),
        }),
      )

    it('has each as a white sheet with its number, 0 to 99', () => {
      const { areas, lines } = marked(7, 10, 99)
      expect(areas.slice(1).map(({ colour }) => colour)).toEqual(Array(3).fill('#FFFFFF'))
      // 42 px with the margin; its middle is at (118, 118) px.
      expect(areas[1]).toMatchObject({ shape: { width: 14, height: 14 }, pose: at(36, 117.33) })
      expect(lines.map(({ id }) => id)).toEqual([
        ...['marker1digit1', 'marker2digit1', 'marker2digit2', 'marker3digit1', 'marker3digit2'],
      ])
      const [seven, one] = lines
      // Along the top to the right, then down.
      expect(seven!.points).toEqual([
        { x: 34.32, y: 121.17 },
        { x: 37.68, y: 121.17 },
        { x: 37.68, y: 113.49 },
      ])
      expect(new Set(one!.points.map(({ x }) => x)).size).toBe(1)
    })

    it('has a sheet without a number for what is none of these', () => {
      expect(marked(100, -1, 0.5).lines).toEqual([])
      expect(marked(100, -1, 0.5).areas).toHaveLength(4)
    })

    it('is refused by name where they are too many', () => {
      expect(() => marked(...Array<number>(51).fill(1))).toThrow(ProjectError)
      expect(marked(...Array<number>(50).fill(99)).lines).toHaveLength(100)
    })
  })

  it('of an older kind has one pose a robot', () => {
    const old = { ...foreign, robotPoses: [{ x: 160 / 750, y: 160 / 480, theta: 0 }] }
    expect(parseScene(JSON.stringify(old)).starts).toEqual([at(50, 103.33)])
  })
})

describe('what is refused, and why', () => {
  const many = (count: number) => Array.from({ length: count }, () => foreign.obstacles[0])
  const oddly = (part: object) => ({ ...foreign, obstacles: [{ ...foreign.obstacles[0], ...part }] })

  it.each([
    ['no JSON', '{', 'sceneNotJson'],
    ['nothing', 'null', 'notAScene'],
    ['a list', '[]', 'notAScene'],
    ['a project', { botgarten: 1 }, 'isAProject'],
    ['a newer scene', { botgartenScene: 2 }, 'newerVersion'],
    ['2,000 things of theirs', { ...foreign, obstacles: many(2000) }, 'tooManyThings'],
    ['101 areas of theirs', { ...foreign, colorAreas: many(101) }, 'tooManyThings'],
    ['2,000 things of ours', { ...ours(), obstacles: many(2000) }, 'tooManyThings'],
    ['101 lines', { ...ours(), lines: many(101) }, 'tooManyThings'],
    ['a place far outside', oddly({ x: 1e6 }), 'notAScene'],
    ['a place that is text', oddly({ x: '1' }), 'notAScene'],
    ['a colour that is none', oddly({ color: 'url(http://x)' }), 'notAScene'],
    ['an unknown form', oddly({ form: 'HEXAGON' }), 'notAScene'],
    [
      'a triangle that is a line',
      oddly({ form: 'TRIANGLE', ax: 0, ay: 0, bx: 0.5, by: 0.5, cx: 1, cy: 1 }),
      'notAScene',
    ],
    ['a picture from elsewhere', { ...ours(), floor: { asset: 'https://example.org/x.png' } }, 'notAScene'],
    ['two things with one id', { ...ours(), lines: [{ ...world.lines[0], id: 'o' }] }, 'notAScene'],
    ['a world without size', { ...ours(), size: { width: 0, height: 5 } }, 'notAScene'],
    ['a key that reaches into every object', `{"__proto__":{},"robotPoses":[]}`, 'notAProject'],
    ['more than 5 MB', ' '.repeat(5_000_001), 'tooBig'],
  ])('%s', (_, data, reason) => {
    expect(reasonOf(data)).toBe(reason)
  })

  it('a hundred things inside each other are allowed', () => {
    expect(reasonOf({ ...foreign, obstacles: many(100) })).toBe('accepted')
  })

  it('2,000 things are named by their number', () => {
    expect(() => parseScene(JSON.stringify({ ...foreign, obstacles: many(2000) }))).toThrow(
      expect.objectContaining({ facts: { count: 2000, most: 100 } }),
    )
  })

  it('any JSON is accepted or refused with a reason, nothing else', () => {
    const answers = ['accepted', 'notAScene', 'isAProject', 'tooManyThings', 'newerVersion', 'notAProject']
    fc.assert(
      fc.property(fc.jsonValue({ maxDepth: 5 }), (value) => {
        expect(answers).toContain(reasonOf(JSON.stringify(value)))
      }),
    )
  })

  it('either file with any one part replaced by anything is accepted or refused with a reason, nothing else', () => {
    const cases = [foreign, ours()].flatMap((file) => pathsIn(file).map((path) => ({ file, path })))
    const odd = fc.oneof(
      fc.jsonValue({ maxDepth: 3 }),
      fc.constantFrom('__proto__', -1, 1e308, {}, [], '#12'),
    )
    fc.assert(
      fc.property(fc.constantFrom(...cases), odd, ({ file, path }, value) => {
        const text = JSON.stringify(replaced(file, path, value))
        if (reasonOf(text) !== 'accepted') return
        const { assets, ...scene } = parseScene(text)
        expect(parseScene(writeScene(scene, assets))).toEqual({
          ...scene,
          assets: expect.anything() as unknown,
        })
      }),
      { numRuns: 1000 },
    )
  })
})
