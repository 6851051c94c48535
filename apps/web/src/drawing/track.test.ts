import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { layoutNetwork } from './network.ts'
import { between, distance, distanceToSegment, type Point } from './points.ts'
import {
  alongMovement,
  freeLine,
  gripsOf,
  knobPlace,
  knobPlaces,
  linksAt,
  linkWidth,
  stagger,
  weightAt,
  type Track,
  pulseRate,
} from './track.ts'

const level = freeLine({ x: 100, y: 50 }, { x: 400, y: 50 }, 50)

/** All links of a network in a room, staggered. */
function network(width: number, height: number, inputs: number, outputs: number): readonly Track[] {
  const layout = layoutNetwork({ width, height }, inputs, outputs)
  const [left = [], right = []] = layout.columns
  const lines = left.flatMap((a) => right.map((b) => freeLine(a, b, layout.radius)))
  return stagger(lines)
}

const tightest = (points: readonly Point[]) =>
  Math.min(...points.flatMap((a, i) => points.slice(i + 1).map((b) => distance(a, b))))

const point = fc.record({ x: fc.integer({ min: 0, max: 900 }), y: fc.integer({ min: 0, max: 600 }) })
const hundredth = fc.integer({ min: 0, max: 100 }).map((part) => part / 100)
const zero = fc.double({ min: 0.12, max: 0.46, noNaN: true })

describe('the track of a link', () => {
  test('runs from 12 % to 82 % of the free length between the nodes', () => {
    expect(level.from.x).toBeCloseTo(149.5)
    expect(level.to.x).toBeCloseTo(350.5)
    expect(knobPlace(level, 0)).toEqual(between(level.from, level.to, 0.12))
    expect(knobPlace(level, 1)).toEqual(between(level.from, level.to, 0.82))
  })

  test('weights beyond 0..1 stand at its ends', () => {
    expect(knobPlace(level, 1.4)).toEqual(knobPlace(level, 1))
    expect(knobPlace(level, -0.5)).toEqual(knobPlace(level, 0))
  })

  test('a weight becomes a place and the place the same weight again', () => {
    fc.assert(
      fc.property(point, point, zero, hundredth, (a, b, start, weight) => {
        fc.pre(distance(a, b) > 150)
        const track = { ...freeLine(a, b, 40), zero: start }
        expect(weightAt(track, knobPlace(track, weight))).toBe(weight)
      }),
    )
  })

  test('of a scale below 0 has weight 0 in its middle, and a knob for each side', () => {
    const signed = freeLine({ x: 100, y: 50 }, { x: 400, y: 50 }, 50, { least: -1, most: 1, unit: 1 })
    expect([knobPlace(signed, -1), knobPlace(signed, 0), knobPlace(signed, 1)]).toEqual(
      [0.12, 0.47, 0.82].map((share) => between(signed.from, signed.to, share)),
    )
    fc.assert(
      fc.property(point, point, fc.integer({ min: -300, max: 300 }), (a, b, part) => {
        fc.pre(distance(a, b) > 150)
        const track = freeLine(a, b, 40, { least: -3, most: 3, unit: 1 })
        expect(weightAt(track, knobPlace(track, part / 100))).toBe(part / 100)
      }),
    )
  })

  test('a finger off the line means the nearest point on it', () => {
    const knob = knobPlace(level, 0.3)
    expect(weightAt(level, { x: knob.x, y: knob.y + 200 })).toBe(0.3)
    expect(weightAt(level, { x: -50, y: 10 })).toBe(0)
    expect(weightAt(level, { x: 999, y: 10 })).toBe(1)
  })

  test('a link is 3 px wide at 0 and 16 px at 1 and at -1', () => {
    expect([linkWidth(0), linkWidth(1), linkWidth(-1), linkWidth(0.8)]).toEqual([3, 16, 16, 13.4])
  })
})

describe('knobs at 0', () => {
  test('keep 44 px apart in a network of two by two, on every screen', () => {
    for (const [width, height] of [
      [456, 416],
      [513, 242],
      [366, 330],
    ] as const)
      expect(tightest(network(width, height, 2, 2).map((track) => knobPlace(track, 0)))).toBeGreaterThan(43.5)
  })

  test('keep 38 px apart three by three in the lowest pane at 1024, and 44 px where there is room', () => {
    expect(tightest(network(513, 242, 3, 3).map((track) => knobPlace(track, 0)))).toBeGreaterThan(38)
    expect(tightest(network(456, 416, 3, 3).map((track) => knobPlace(track, 0)))).toBeGreaterThan(44)
    expect(tightest(network(900, 600, 3, 3).map((track) => knobPlace(track, 0)))).toBeGreaterThan(44)
  })

  test('stay on the first half of their links, whatever the network', () => {
    const size = fc.integer({ min: 1, max: 6 })
    fc.assert(
      fc.property(size, size, fc.integer({ min: 340, max: 1200 }), (inputs, outputs, width) => {
        const tracks = network(width, 300, inputs, outputs)
        expect(tracks).toHaveLength(inputs * outputs)
        for (const track of tracks) expect(track.zero >= 0.12 && track.zero <= 0.47).toBe(true)
      }),
      { numRuns: 30 },
    )
  })
})

describe('where knobs answer to a pointer', () => {
  const knobs = fc.array(point, { minLength: 1, maxLength: 12 })

  test('is never the place of two, and always the knob that is nearest', () => {
    fc.assert(
      fc.property(knobs, point, (places, at) => {
        const radii = gripsOf(places)
        places.forEach((one, i) =>
          places.slice(i + 1).forEach((other, k) => {
            const apart = distance(one, other)
            if (apart >= 22) expect(radii[i]! + radii[i + 1 + k]!).toBeLessThanOrEqual(apart + 1e-9)
          }),
        )
        const pressed = places.findIndex((place, i) => distance(place, at) < radii[i]! - 1e-9)
        if (pressed < 0 || radii[pressed]! <= 11) return
        const nearest = Math.min(...places.map((place) => distance(place, at)))
        expect(distance(places[pressed]!, at)).toBe(nearest)
      }),
    )
  })

  test('is 48 px wide where there is room, and as wide as they are apart where there is not', () => {
    expect(gripsOf([{ x: 0, y: 0 }])).toEqual([24])
    expect(
      gripsOf([
        { x: 0, y: 0 },
        { x: 31, y: 0 },
        { x: 100, y: 0 },
      ]),
    ).toEqual([15.5, 15.5, 24])
    expect(
      gripsOf([
        { x: 0, y: 0 },
        { x: 3, y: 0 },
      ]),
    ).toEqual([11, 11])
  })
})

describe('a finger', () => {
  const cross = [
    freeLine({ x: 0, y: 0 }, { x: 400, y: 200 }, 20),
    freeLine({ x: 0, y: 200 }, { x: 400, y: 0 }, 20),
  ]

  test('takes the nearest knob within 24 px before any line', () => {
    const knob = knobPlace(cross[1]!, 0)
    expect(linksAt(cross, [0, 0], { x: knob.x, y: knob.y + 20 })).toEqual([1])
  })

  test('takes the nearest of several knobs within reach, whichever way it goes', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 14, max: 47 }),
        fc.integer({ min: 0, max: 359 }),
        fc.nat(),
        (gap, turn, far) => {
          const beside = { x: level.from.x, y: level.from.y + gap }
          const tracks = [level, { ...level, from: beside, to: { x: level.to.x, y: level.to.y + gap } }]
          const knob = knobPlaces(tracks, [0, 0])[0]!
          // Nearer to this knob than to the other by more than a finger trembles.
          const reach = far % Math.floor(gap / 2 - 3)
          const at = {
            x: knob.x + reach * Math.cos((turn * Math.PI) / 180),
            y: knob.y + reach * Math.sin((turn * Math.PI) / 180),
          }
          expect(linksAt(tracks, [0, 0], at)).toEqual([0])
        },
      ),
    )
  })

  test('takes the nearest line where no knob is', () => {
    const place = between(cross[0]!.from, cross[0]!.to, 0.9)
    expect(linksAt(cross, [0, 0], { x: place.x, y: place.y + 10 })).toEqual([0])
    expect(linksAt(cross, [0, 0], { x: place.x, y: place.y + 60 })).toEqual([])
  })

  test('on two knobs that meet takes the link in whose direction it moves', () => {
    const middle = (0.5 - 0.12) / 0.7
    const both = linksAt(cross, [middle, middle], { x: 200, y: 100 })
    expect([...both].sort()).toEqual([0, 1])
    expect(alongMovement(cross, both, { x: 5, y: 3 })).toBe(0)
    expect(alongMovement(cross, both, { x: 5, y: -3 })).toBe(1)
  })
})

describe('knobs that meet', () => {
  const [down, up] = [
    freeLine({ x: 0, y: 0 }, { x: 400, y: 200 }, 20),
    freeLine({ x: 0, y: 200 }, { x: 400, y: 0 }, 20),
  ] as const
  const crossing = (0.5 - 0.12) / 0.7

  test('are told apart, on their own links, whichever weights and links they have', () => {
    const weight = fc.integer({ min: 0, max: 100 }).map((part) => part / 100)
    const height = fc.integer({ min: 40, max: 400 })
    fc.assert(
      fc.property(weight, weight, height, (one, other, y) => {
        const tracks = [
          freeLine({ x: 0, y: 0 }, { x: 400, y }, 20),
          freeLine({ x: 0, y }, { x: 400, y: 0 }, 20),
        ]
        const places = knobPlaces(tracks, [one, other])
        expect(distance(places[0]!, places[1]!)).toBeGreaterThanOrEqual(22)
        for (const [i, place] of places.entries()) {
          expect(distanceToSegment(tracks[i]!.from, tracks[i]!.to, place)).toBeLessThan(0.01)
          expect(distance(place, knobPlace(tracks[i]!, [one, other][i]!))).toBeLessThanOrEqual(24)
        }
      }),
    )
  })

  test('stay where their weights are while they can be told apart', () => {
    expect(knobPlaces([down, up], [0.2, 0.9])).toEqual([knobPlace(down, 0.2), knobPlace(up, 0.9)])
  })

  test('make room for the one that is held', () => {
    const places = knobPlaces([down, up], [crossing, crossing], 1)
    expect(places[1]).toEqual(knobPlace(up, crossing))
    expect(distance(places[0]!, places[1]!)).toBeGreaterThanOrEqual(22)
  })

  test('each answer to a finger on them', () => {
    const places = knobPlaces([down, up], [crossing, crossing])
    for (const [i, place] of places.entries())
      expect(linksAt([down, up], [crossing, crossing], place)).toEqual([i])
  })
})

describe('pulses', () => {
  test('take 900 ms at 50 and 500 ms at 100, and at most 1600 ms', () => {
    expect(pulseRate(50).milliseconds).toBe(900)
    expect(pulseRate(100).milliseconds).toBe(500)
    expect(pulseRate(1).milliseconds).toBeLessThanOrEqual(1600)
    expect(pulseRate(300)).toEqual(pulseRate(100))
  })

  test('stop where there is no signal, and are never more than 8', () => {
    expect(pulseRate(0).count).toBe(0)
    expect([2, 20, 50, 80].map((signal) => pulseRate(signal).count)).toEqual([1, 2, 4, 8])
  })

  test('a trembling value changes nothing', () => {
    expect(pulseRate(54)).toEqual(pulseRate(55.4))
  })
})
