import { encode } from 'fast-png'
import { describe, expect, test } from 'vitest'
import { pose } from '../testing/worlds.ts'
import type { Colour, Floor, World } from '../types.ts'
import { COLOURS, colourOf } from './colours.ts'
import { bytesOf } from './fill.ts'
import { paintFloor } from './paint.ts'
import { FloorError, readPng } from './png.ts'

type Painted = Pick<World, 'size' | 'floor' | 'areas' | 'lines'>
const bare: Painted = { size: { width: 100, height: 50 }, floor: { colour: '#FFFFFF' }, areas: [], lines: [] }

/** Colour of the pixel that lies under a place. */
function at(floor: Floor, x: number, y: number): Colour {
  const column = Math.floor(x * floor.pixelsPerCm)
  const row = floor.height - 1 - Math.floor(y * floor.pixelsPerCm)
  const from = (row * floor.width + column) * 3
  const hex = [...floor.data.subarray(from, from + 3)].map((byte) => byte.toString(16).padStart(2, '0'))
  return `#${hex.join('').toUpperCase()}`
}

/** How many cm² have a colour. */
function areaOf(floor: Floor, colour: Colour): number {
  const [r, g, b] = bytesOf(colour)
  let pixels = 0
  for (let from = 0; from < floor.data.length; from += 3)
    if (floor.data[from] === r && floor.data[from + 1] === g && floor.data[from + 2] === b) pixels++
  return pixels / floor.pixelsPerCm / floor.pixelsPerCm
}

describe('rule 6: the floor', () => {
  test('rule 1: y goes up: the row at the top is the highest', () => {
    const areas = [
      { id: 'a', shape: { kind: 'rectangle', width: 10, height: 10 }, pose: pose(5, 45), colour: '#B30006' },
    ] as const
    const floor = paintFloor({ ...bare, areas })
    expect([...floor.data.subarray(0, 3)]).toEqual([0xb3, 0x00, 0x06])
    expect(at(floor, 5, 45)).toBe('#B30006')
    expect(at(floor, 5, 5)).toBe('#FFFFFF')
  })

  test.each([
    ['rectangle', { kind: 'rectangle', width: 30, height: 16 }, 480],
    ['triangle', { kind: 'triangle', width: 30, height: 16 }, 240],
    ['circle', { kind: 'circle', radius: 12 }, Math.PI * 144],
  ] as const)('a %s covers its area, turned or not, and has no in-between colours', (_, shape, area) => {
    for (const heading of [0, 30, 45, 90, 233]) {
      const areas = [{ id: 'a', shape, pose: pose(50, 25, heading), colour: '#0057A6' }]
      const floor = paintFloor({ ...bare, areas })
      expect(Math.abs(areaOf(floor, '#0057A6') - area)).toBeLessThan(area * 0.02)
      expect(areaOf(floor, '#0057A6') + areaOf(floor, '#FFFFFF')).toBe(5000)
    }
  })

  test('a triangle stands on its width with the tip in +y', () => {
    const shape = { kind: 'triangle', width: 30, height: 20 } as const
    const floor = paintFloor({ ...bare, areas: [{ id: 'a', shape, pose: pose(50, 25), colour: '#000000' }] })
    expect(at(floor, 50, 34)).toBe('#000000')
    expect([at(floor, 38, 16), at(floor, 62, 16)]).toEqual(['#000000', '#000000'])
    expect([at(floor, 40, 33), at(floor, 60, 33)]).toEqual(['#FFFFFF', '#FFFFFF'])
  })

  test('a line is everything within half its width of its way', () => {
    const points = [{ x: 20, y: 10 }, { x: 60, y: 10 }, { x: 60, y: 40 }] // prettier-ignore
    const floor = paintFloor({ ...bare, lines: [{ id: 'l', points, width: 6, colour: '#000000' }] })
    for (let x = 0.125; x < 100; x += 0.25) {
      for (let y = 0.125; y < 50; y += 0.25) {
        const far = Math.min(toSegment(x, y, points[0]!, points[1]!), toSegment(x, y, points[1]!, points[2]!))
        if (Math.abs(far - 3) > 1e-9) expect(at(floor, x, y)).toBe(far < 3 ? '#000000' : '#FFFFFF')
      }
    }
  })

  test('areas lie over the picture, lines over areas, later over earlier; what leaves the floor is cut', () => {
    const big = { kind: 'circle', radius: 500 } as const
    const areas = [
      { id: 'a', shape: big, pose: pose(0, 0), colour: '#B30006' },
      { id: 'b', shape: big, pose: pose(0, 0), colour: '#00642E' },
    ]
    const lines = [{ id: 'l', points: [{ x: -50, y: 25 }, { x: 150, y: 25 }], width: 4, colour: '#0057A6' }] // prettier-ignore
    const floor = paintFloor({ ...bare, areas, lines })
    expect(areaOf(floor, '#0057A6')).toBe(400)
    expect(areaOf(floor, '#00642E')).toBe(4600)
  })

  test.each([
    [600, 400],
    [100, 50],
    [5000, 300],
    [10, 9000],
    [1, 1],
  ])('a floor of %d × %d cm needs at most 1600 × 1200 pixels', (width, height) => {
    const floor = paintFloor({ ...bare, size: { width, height } })
    expect(floor.width).toBeLessThanOrEqual(1600)
    expect(floor.height).toBeLessThanOrEqual(1200)
    expect(floor.data.length).toBe(floor.width * floor.height * 3)
  })
})

function toSegment(x: number, y: number, a: { x: number; y: number }, b: { x: number; y: number }): number {
  const t = ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / ((b.x - a.x) ** 2 + (b.y - a.y) ** 2)
  const held = Math.max(0, Math.min(1, t))
  return Math.hypot(x - a.x - held * (b.x - a.x), y - a.y - held * (b.y - a.y))
}

describe('rule 6: pictures', () => {
  const picture = (width: number, height: number, channels: 1 | 2 | 3 | 4, pixel: readonly number[]) =>
    encode({ width, height, channels, depth: 8, data: Uint8Array.from({ length: width * height * channels }, (_, i) => pixel[i % channels]!) }) // prettier-ignore

  test.each([
    ['RGB', 3, [0, 87, 166], '#0057A6'],
    ['RGBA', 4, [0, 87, 166, 255], '#0057A6'],
    ['grey', 1, [88], '#585858'],
    ['grey with transparency', 2, [88, 0], '#FFFFFF'],
    ['half transparent black over white', 4, [0, 0, 0, 127], '#808080'],
  ] as const)('%s is read', (_, channels, pixel, colour) => {
    const floor = paintFloor({ ...bare, floor: { asset: 'x' } }, readPng(picture(200, 100, channels, pixel)))
    expect([floor.width, floor.height, floor.pixelsPerCm]).toEqual([200, 100, 2])
    expect(areaOf(floor, colour)).toBe(5000)
  })

  test('a palette is read', () => {
    // 2 × 1 pixels, red and white, made with Python's zlib after the PNG specification.
    const png = Uint8Array.from(Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAMAAADD/I+4AAAABlBMVEWzAAb///8c7KHaAAAAC0lEQVR4nGNgYAQAAAQAAr96P0oAAAAASUVORK5CYII=', 'base64')) // prettier-ignore
    const floor = paintFloor({ ...bare, size: { width: 2, height: 1 } }, readPng(png))
    expect([...floor.data]).toEqual([0xb3, 0, 6, 255, 255, 255])
  })

  test('a picture of another shape is stretched over the world', () => {
    const data = new Uint8Array([255, 0, 0, 0, 0, 255])
    const floor = paintFloor(bare, readPng(encode({ width: 2, height: 1, channels: 3, depth: 8, data })))
    expect([at(floor, 10, 5), at(floor, 10, 45), at(floor, 90, 5)]).toEqual(['#FF0000', '#FF0000', '#0000FF'])
    const high = paintFloor(
      { ...bare, size: { width: 100, height: 400 } },
      readPng(picture(1600, 1000, 3, [1, 2, 3])),
    )
    expect([high.width, high.height]).toEqual([300, 1200])
    expect(areaOf(high, '#010203')).toBeCloseTo(40000, 6)
  })

  const problemOf = (png: Uint8Array) => {
    try {
      paintFloor(bare, readPng(png))
      return null
    } catch (error) {
      return error instanceof FloorError ? error.problem : error
    }
  }
  /** A picture whose header says another size. */
  const saying = (width: number, height: number, from = picture(8, 8, 3, [1, 2, 3])) => {
    const png = from.slice()
    new DataView(png.buffer).setUint32(16, width)
    new DataView(png.buffer).setUint32(20, height)
    return png
  }

  test.each([
    [1601, 1],
    [1, 1201],
    [100_000, 100_000],
    [0xffffffff, 0xffffffff],
  ])('a header that says %d × %d is refused before anything is unpacked', (width, height) => {
    expect(problemOf(saying(width, height))).toBe('tooBig')
  })

  test('data that unpacks to more than the picture needs is refused', () => {
    expect(problemOf(saying(8, 8, picture(1600, 1200, 3, [0, 0, 0])))).toBe('tooBig')
  })

  test.each([
    ['nothing', new Uint8Array(0), 'notPng'],
    ['a text', new TextEncoder().encode('not a picture at all'), 'notPng'],
    ['a JPEG', new Uint8Array([0xff, 0xd8, 0xff, 0xe0, 0, 16]), 'notPng'],
    ['half a picture', picture(64, 64, 3, [1, 2, 3]).slice(0, 60), 'broken'],
    ['no pixels', saying(0, 8), 'broken'],
    ['fewer rows than it says', saying(8, 900), 'broken'],
    [
      '16 bits a channel',
      encode({ width: 2, height: 2, channels: 1, depth: 16, data: new Uint16Array(4) }),
      'broken',
    ],
  ] as const)('%s is refused', (_, png, problem) => {
    expect(problemOf(png)).toBe(problem)
  })

  test('any byte may be wrong: there is a floor or a FloorError', () => {
    const png = picture(40, 20, 4, [9, 8, 7, 200])
    for (let index = 0; index < png.length; index++) {
      for (const flip of [0x01, 0x80, 0xff]) {
        const broken = png.slice()
        broken[index] = broken[index]! ^ flip
        expect(['notPng', 'tooBig', 'broken', null]).toContain(problemOf(broken))
      }
    }
  })
})

describe('colour names', () => {
  test.each(Object.entries(COLOURS))('%s names itself', (_, colour) => {
    expect(colourOf(...(bytesOf(colour) as [number, number, number]))).toBe(colour)
  })

  // By the table in the spec (hue, saturation, value), worked out by hand.
  test.each([
    [25, 25, 25, '#000000'], // v 9.8
    [26, 26, 26, '#585858'], // v 10.2, s 0
    [229, 229, 229, '#585858'], // v 89.8
    [231, 231, 231, '#FFFFFF'], // v 90.6
    [255, 0, 0, '#B30006'], // h 0, s 100, v 100
    [127, 0, 0, null], // red, but v 49.8; saturation 100 is no brown
    [255, 255, 0, '#F7D117'], // h 60
    [255, 128, 0, null], // h 30: neither red nor yellow
    [100, 40, 20, '#532115'], // h 15, s 80, v 39
    [0, 255, 0, '#00642E'], // h 120
    [0, 0, 255, '#0057A6'], // h 240
    [0, 255, 255, null], // h 180
    [255, 0, 255, null], // h 300
  ] as const)('rgb %d %d %d is %s', (r, g, b, colour) => {
    expect(colourOf(r, g, b)).toBe(colour)
  })
})
