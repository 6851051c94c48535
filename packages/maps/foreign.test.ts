import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { pointsAlong, readMap, segmentsOf, type MapFile, type Point } from './index.ts'
import roads from './reference/roads.json' with { type: 'json' }
import transforms from './reference/transforms.json' with { type: 'json' }

const svg = (content: string, root = 'viewBox="0 0 1000 1000"') =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ${root}>${content}</svg>`
const circle = (id: number, { x, y }: Point, radius = 1) =>
  `<circle id="node-${id}" cx="${x}" cy="${y}" r="${radius}"/>`
const path = (name: string, data: string) => `<path id="path-${name}" d="${data}"/>`

function mapIn(text: string): MapFile {
  const { map, problems } = readMap(text)
  expect(problems).toEqual([])
  return map!
}

const gap = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y)
const pointOf = ([x, y]: readonly number[]): Point => ({ x: x!, y: y! })

/** The point at a share of a road, by its length. */
function pointAt(line: string, share: number): Point {
  const segments = segmentsOf(line)!
  const points = [segments[0]!.from, ...segments.flatMap((one) => pointsAlong(one, 0.5))]
  const steps = points.slice(1).map((to, index) => gap(points[index]!, to))
  let left = steps.reduce((sum, step) => sum + step, 0) * share
  const index = steps.findIndex((step) => (left -= step) <= 0)
  return index < 0 ? points.at(-1)! : points[index + 1]!
}

describe('a road of any path commands is as long, and leads where svgpathtools says', () => {
  test.each(roads.map((road, index) => ({ index, ...road })))('$index: $data', ({ data, length, points }) => {
    const [start, end] = [pointOf(points[0]!), pointOf(points.at(-1)!)]
    const { map, roads } = mapIn(svg(circle(0, start) + circle(1, end) + path('0-1', data)))
    expect(Math.abs(map.actions[0]![0]!.length! - length)).toBeLessThan(1e-3 * length)
    points.forEach((point, eighth) => {
      expect(gap(pointAt(roads['0-1']!, eighth / 8), pointOf(point))).toBeLessThan(1 + 2e-3 * length)
    })
  })
})

describe('a transform', () => {
  const placed = (text: string, point: Point) =>
    readMap(svg(`<g transform="${text}">${circle(0, point)}</g>`))

  test.each(transforms)('$text is what Chromium makes of it', ({ text, matrix }) => {
    const { map, problems } = placed(text, { x: 30, y: 20 })
    if (matrix === null)
      return expect(problems).toEqual([{ kind: 'transform', facts: { name: 'node-0', value: text } }])
    const [a, b, c, d, e, f] = matrix as [number, number, number, number, number, number]
    const there = { x: a * 30 + c * 20 + e, y: b * 30 + d * 20 + f }
    expect(gap(map!.stations[0]!, there)).toBeLessThan(1e-5 * (1 + Math.hypot(there.x, there.y)))
  })

  const number = (least: number, most: number) =>
    fc.integer({ min: least * 100, max: most * 100 }).map((hundredths) => hundredths / 100)
  type Row = readonly [number, number, number]
  /** A transform as text, and as the matrix of SVG 1.1, 7.6. */
  interface One {
    readonly text: string
    readonly rows: readonly [Row, Row]
  }
  const turn = (degrees: number) => (degrees * Math.PI) / 180
  const one: fc.Arbitrary<One> = fc.oneof(
    fc.tuple(number(-500, 500), number(-500, 500)).map(([x, y]): One => ({
      text: `translate(${x} ${y})`,
      rows: [
        [1, 0, x],
        [0, 1, y],
      ],
    })),
    fc.tuple(number(0.3, 2), number(-2, -0.3)).map(([x, y]): One => ({
      text: `scale(${x},${y})`,
      rows: [
        [x, 0, 0],
        [0, y, 0],
      ],
    })),
    number(-360, 360).map((angle): One => {
      const [c, s] = [Math.cos(turn(angle)), Math.sin(turn(angle))]
      return {
        text: `rotate(${angle})`,
        rows: [
          [c, -s, 0],
          [s, c, 0],
        ],
      }
    }),
    fc.tuple(number(-360, 360), number(-500, 500), number(-500, 500)).map(([angle, x, y]): One => {
      const [c, s] = [Math.cos(turn(angle)), Math.sin(turn(angle))]
      return {
        text: `rotate(${angle}, ${x}, ${y})`,
        rows: [
          [c, -s, x - c * x + s * y],
          [s, c, y - s * x - c * y],
        ],
      }
    }),
    fc.tuple(fc.boolean(), number(-60, 60)).map(([along, angle]): One => {
      const tan = Math.tan(turn(angle))
      return {
        text: `${along ? 'skewX' : 'skewY'}(${angle})`,
        rows: [
          [1, along ? tan : 0, 0],
          [along ? 0 : tan, 1, 0],
        ],
      }
    }),
    fc.tuple(number(-2, 2), number(-2, 2), number(-9, 9)).map(([a, b, e]): One => ({
      text: `matrix(${a} ${b} 0.5 1 ${e} 7)`,
      rows: [
        [a, 0.5, e],
        [b, 1, 7],
      ],
    })),
  )
  const times = ([[a, b, c], [d, e, f]]: One['rows'], { x, y }: Point): Point => ({
    x: a * x + b * y + c,
    y: d * x + e * y + f,
  })
  const lists = fc.array(fc.array(one, { minLength: 1, maxLength: 3 }), { maxLength: 4 })
  const places = fc.tuple(number(-300, 300), number(-300, 300)).map(pointOf)

  test('groups in groups move stations and roads as their matrices, one after the other', () => {
    fc.assert(
      fc.property(lists, places, places, (groups, a, b) => {
        const open = groups.map((list) => `<g transform="${list.map(({ text }) => text).join(' ')}">`)
        const road = path('0-1', `M${a.x} ${a.y}L${b.x} ${b.y}`)
        const text = svg(open.join('') + circle(0, a) + circle(1, b) + road + '</g>'.repeat(groups.length))
        const { stations, map } = mapIn(text)
        const [from, to] = [a, b].map((point) =>
          groups.flat().reduceRight((at, { rows }) => times(rows, at), point),
        ) as [Point, Point]
        const size = 1 + Math.hypot(from.x, from.y) + Math.hypot(to.x, to.y)
        expect(gap(stations[0]!, from) / size).toBeLessThan(1e-9)
        expect(gap(stations[1]!, to) / size).toBeLessThan(1e-9)
        expect(Math.abs(map.actions[0]![0]!.length! - gap(from, to)) / size).toBeLessThan(1e-5)
      }),
      { seed: 15 },
    )
  })

  test('a group that is moved itself stands where its own 0, 0 comes to lie', () => {
    const node = (id: number, transform: string) => `<g id="node-${id}" transform="${transform}"><rect/></g>`
    const content = node(0, 'matrix(0 1 -1 0 30 40)') + node(1, 'rotate(90 100 0) translate(100 50)')
    const { stations } = mapIn(svg(`<g transform="scale(2)">${content}</g>`))
    expect(gap(stations[0]!, { x: 60, y: 80 })).toBeLessThan(1e-9)
    expect(gap(stations[1]!, { x: 100, y: 0 })).toBeLessThan(1e-9)
  })

  test('on the road itself bends an arc of a circle into one of an ellipse', () => {
    const half = `<path id="path-0-1" transform="scale(2 1)" d="M10 50a40 40 0 0 1 80 0"/>`
    const { map } = mapIn(svg(circle(0, { x: 20, y: 50 }) + circle(1, { x: 180, y: 50 }) + half))
    // Half the ellipse with axes 80 and 40: 40 times the complete elliptic integral of the second kind, twice over.
    expect(map.actions[0]![0]!.length!).toBeCloseTo(193.77, 1)
  })

  test('that cannot be read is named with what it moves, wherever it stands', () => {
    const broken = `<g transform="turn(3)"><g>${circle(0, { x: 0, y: 0 })}${path('0-0', 'M0 0')}</g></g>`
    expect(readMap(svg(broken)).problems).toContainEqual({
      kind: 'transform',
      facts: { name: 'node-0', value: 'turn(3)' },
    })
  })
})

describe('a station', () => {
  const ends = path('0-1', 'M100 100H300') + path('1-0', 'M300 100H100')

  test('as circle, ellipse or rectangle is at its middle; roads may end at its rim', () => {
    const shapes = [
      '<circle id="node-0" cx="90" cy="100" r="10"/><circle id="node-1" cx="310px" cy="100" r="10"/>',
      '<ellipse id="node-0" cx="90" cy="100" rx="10" ry="4"/><rect id="node-1" x="300" y="90" width="20" height="20"/>',
    ]
    for (const shape of shapes)
      expect(mapIn(svg(shape + ends)).stations).toEqual([
        { x: 90, y: 100 },
        { x: 310, y: 100 },
      ])
  })

  test('as a picture is at its round shape where all roads reach that, else where the roads meet', () => {
    const dot = '<g id="node-0"><path d="M0 0"/><g><circle cx="98" cy="100" r="4"/></g></g>'
    const pin = '<g id="node-1"><path d="M0 0"/><circle cx="300" cy="40" r="9"/></g>'
    expect(mapIn(svg(dot + pin + ends)).stations).toEqual([
      { x: 98, y: 100 },
      { x: 300, y: 100 },
    ])
  })

  test('as a picture that was moved after it was drawn is where its round shape has come to', () => {
    const moved = '<g id="node-0" transform="translate(-5 60)"><circle cx="105" cy="40" r="8"/></g>'
    expect(mapIn(svg(moved + circle(1, { x: 300, y: 100 }) + ends)).stations[0]).toEqual({ x: 100, y: 100 })
  })

  test('that was stretched or turned takes roads that end at its new rim', () => {
    const middle = circle(0, { x: 0, y: 0 }, 10)
    const placed = (matrix: string) => middle.replace('/>', ` transform="matrix(${matrix})"/>`)
    const other = circle(1, { x: 300, y: 100 })
    // Three times as wide: the rim is 30 units from the middle.
    expect(mapIn(svg(placed('3 0 0 1 70 100') + other + ends)).stations[0]).toEqual({ x: 70, y: 100 })
    // A quarter turn: the rim is still 10 units away.
    expect(mapIn(svg(placed('0 1 -1 0 90 100') + other + ends)).stations[0]).toEqual({ x: 90, y: 100 })
  })

  test('whose roads end far from each other is named with the road', () => {
    const text = svg(
      '<g id="node-0"/>' +
        circle(1, { x: 300, y: 100 }) +
        path('0-1', 'M100 100H300') +
        path('1-0', 'M300 100H160'),
    )
    expect(readMap(text).problems).toContainEqual({
      kind: 'pathEnd',
      facts: { name: 'path-0-1', station: 0 },
    })
  })

  test('without any place is named', () => {
    expect(readMap(svg('<g id="node-0"/><circle id="node-1" cx="1cm"/>')).problems).toEqual(
      ['node-0', 'node-1'].map((name) => ({ kind: 'stationPlace', facts: { name } })),
    )
  })
})

describe('a drawing of another program', () => {
  const two = circle(0, { x: 0, y: 0 }) + circle(1, { x: 100, y: 0 })

  test('as Inkscape saves it: its notes, styles and lengths', () => {
    const text = `<?xml version="1.0"?><svg width="800px" height="600" xmlns="http://www.w3.org/2000/svg"
      xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
      xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">
      <sodipodi:namedview id="namedview7"><inkscape:grid type="xygrid"/></sodipodi:namedview><defs id="defs2"/>
      <g inkscape:groupmode="layer" style="display:inline;fill:url(#a)" transform="translate(10,20)">${two}
      <path id="path-0-1" style="fill:none" d="m 0,0 h 50 v 0 h 50"/></g></svg>`
    const map = mapIn(text)
    expect(map.size).toEqual({ width: 800, height: 600 })
    expect(map.stations[1]).toEqual({ x: 110, y: 20 })
    expect(map.map.actions[0]).toEqual([{ to: 1, length: 100 }])
  })

  test('as Illustrator saves it: gradients that lead to each other, a road drawn there and there again', () => {
    const defs =
      '<defs><linearGradient id="a"><stop offset="0"/></linearGradient><linearGradient xlink:href="#a"/></defs>'
    const road = '<path id="path-0-1" d="M0,0,100,0m-100,0L100,0" stroke="url(#a)"/>'
    expect(mapIn(svg(defs + two + road)).map.actions[0]).toEqual([{ to: 1, length: 100 }])
  })

  test('may begin anywhere: the map begins at 0, 0', () => {
    expect(mapIn(svg(two, 'viewBox="-50 -20 400 300"'))).toMatchObject({
      size: { width: 400, height: 300 },
      stations: [
        { x: 50, y: 20 },
        { x: 150, y: 20 },
      ],
    })
  })

  test('may have roads as lines and polylines', () => {
    const line = '<line id="path-0-1" x2="100"/><polyline id="path-1-0" points="100,0 50 30 0,0"/>'
    const [there, back] = mapIn(svg(two + line)).map.actions.map(([move]) => move!.length!)
    expect(there).toBe(100)
    expect(back).toBeCloseTo(2 * Math.hypot(50, 30), 9)
  })

  test.each([
    ['x:script', `<x:script xmlns:x="http://www.w3.org/2000/svg"/>`],
    ['div', '<div xmlns="http://www.w3.org/1999/xhtml"/>'],
    ['path', '<path xmlns="http://www.w3.org/1999/xhtml"/>'],
    ['inkscape:path', '<inkscape:path/>'],
    ['style', '<style>@import url(x)</style>'],
    ['style', '<g style="fill:u\\72l(http://x)"/>'],
    ['style', '<g style="fill:url(http://x)"/>'],
    ['xlink:href', '<linearGradient xlink:href="http://x"/>'],
    ['x:onload', '<g x:onload="1"/>'],
    ['use', '<use href="#a"/>'],
  ])('is not taken with %s in it', (name, content) => {
    expect(readMap(svg(two + content)).problems).toEqual([{ kind: 'unsafe', facts: { name } }])
  })

  test('names that are nearly those of stations and roads are named', () => {
    const names = ['path-a-b', 'path-7-18-2', 'path-01-2', 'node-start', 'Node-1', 'node_2', 'path_0_1']
    const { map, warnings } = readMap(svg(two + names.map((name) => `<g id="${name}"/>`).join('')))
    expect(warnings).toEqual(names.map((name) => ({ kind: 'strangeId', facts: { name } })))
    expect(map!.map.actions).toEqual([[], []])
    expect(readMap(svg('<g id="nodes"/><g id="pathes"/><g id="path12"/>' + two)).warnings).toEqual([])
    expect(readMap(svg('<g id="node_0"/>'))).toMatchObject({
      problems: [{ kind: 'noStations' }],
      warnings: [{ facts: { name: 'node_0' } }],
    })
  })

  test.each([
    ['a jump in a road', path('0-1', 'M0 0H50M60 0H100'), { kind: 'pathGap', facts: { name: 'path-0-1' } }],
    [
      'a road of a letter that SVG does not know',
      path('0-1', 'M0 0R9 9 100 0'),
      { kind: 'pathShape', facts: { name: 'path-0-1' } },
    ],
    ['a road that is a group', '<g id="path-0-1"/>', { kind: 'pathShape', facts: { name: 'path-0-1' } }],
    ['a road without end', path('0-1', 'M0 0H1e9'), { kind: 'tooFar', facts: { name: 'path-0-1' } }],
    [
      'a road of infinite numbers',
      path('0-1', 'M0 0C1e999 0 0 0 100 0'),
      { kind: 'tooFar', facts: { name: 'path-0-1' } },
    ],
    [
      'a road of too many pieces',
      path('0-1', `M0 0${'h0'.repeat(500)}H100`),
      { kind: 'pathPieces', facts: { name: 'path-0-1', most: 500 } },
    ],
  ])('%s is named', (_, content, problem) => {
    expect(readMap(svg(two + content)).problems).toEqual([problem])
  })

  test('whatever stands in path data and transforms, the map is read or refused', () => {
    const letters = fc.string({ unit: fc.constantFrom(...'MmLlHhVvCcSsQqTtAaZzRe0159.,- '), maxLength: 60 })
    const words = fc.string({
      unit: fc.constantFrom('rotate(', 'scale(', 'matrix(', ')', ' ', ',', '1', '-', '.', 'e9'),
      maxLength: 12,
    })
    fc.assert(
      fc.property(letters, words, words, (data, outer, inner) => {
        const road = `<path id="path-0-1" transform="${inner}" d="M${data}"/>`
        const { map, problems } = readMap(svg(`<g transform="${outer}">${two}${road}</g>`))
        expect(map === null).toBe(problems.length > 0)
        const numbers = map?.map.actions.flat().map(({ length }) => length!) ?? []
        expect(numbers.every(Number.isFinite)).toBe(true)
      }),
      { seed: 15, numRuns: 2000 },
    )
  })
})

describe('a hostile drawing is read or refused within 200 ms of work', () => {
  const many = (count: number, one: (index: number) => string) =>
    Array.from({ length: count }, (_, index) => one(index)).join('')
  const chain = (data: string, roads = 94) =>
    many(roads + 1, (id) => `<circle id="node-${id}" r="9"/>`) +
    many(roads, (id) => path(`${id}-${id + 1}`, data))
  test.each([
    ['groups in groups', svg('<g>'.repeat(300_000)), 'tooDeep'],
    ['elements', svg('<g/>'.repeat(200_000)), 'tooManyElements'],
    ['attributes', svg(`<g ${many(90_000, (index) => `a${index}="1" `)}/>`), 'tooManyAttributes'],
    ['namespaces', svg(`<g ${many(40_000, (index) => `xmlns:a${index}="b" `)}/>`), 'tooManyAttributes'],
    ['broken entities', svg(`<text>${'&x;'.repeat(300_000)}</text>`), 'notXml'],
    ['nothing but <', '<'.repeat(999_999), 'notXml'],
    ['comments in comments', `<svg>${'<!--'.repeat(200_000)}`, 'notXml'],
    ['a text without end', svg(`<text>${'x'.repeat(990_000)}</text>`), 'noStations'],
    ['transforms', svg(`<g id="node-0" transform="${'rotate(1) '.repeat(90_000)}"/>`), 'transform'],
    [
      'a path without end',
      svg(circle(0, { x: 0, y: 0 }) + path('0-0', `M0 0${'L1 1'.repeat(200_000)}`)),
      'pathsLong',
    ],
    ['arcs', svg(chain(`M0 0${'a5 3 30 0110 10'.repeat(490)}`)), 'pathsLong'],
    ['cusps', svg(chain(`M0 0${'c9 9-9 9 0 0'.repeat(490)}`)), 'pathsLong'],
    ['half as many arcs as it may have', svg(chain(`M0 0${'a5 3 30 0110 10'.repeat(490)}`, 4)), 'pathEnd'],
    [
      'half as many cusps as it may have',
      svg(chain(`M0 0${'c9 9-9 9 0 0'.repeat(490)}L50 50`, 4)),
      'pathEnd',
    ],
    ['turned lines', svg(`<g transform="rotate(3)">${chain(`M0 0L${'1 1 '.repeat(490)}`)}</g>`), 'pathsLong'],
    ['stations', svg(many(4_900, (id) => `<g id="node-${id}"/>`)), 'tooManyStations'],
    [
      'roads from one station',
      svg(
        many(490, (id) => `<g id="node-${id}"><circle r="9"/></g>`) +
          many(4_000, (id) => path(`0-${id}`, 'M0 0L1 1')),
      ),
      'pathToItself',
    ],
  ] as const)('%s', (_, text, kind) => {
    readMap(text)
    const before = process.threadCpuUsage()
    const { problems } = readMap(text)
    const { user, system } = process.threadCpuUsage(before)
    expect(problems.map((problem) => problem.kind)).toContain(kind)
    expect((user + system) / 1000).toBeLessThan(200)
  })
})
