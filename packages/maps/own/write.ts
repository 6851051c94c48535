import { paper, type MapDocument, type MapRoad, type RoadMap } from '@botgarten/programs'
import { distance, type Point } from '../point.ts'
import { bridgeStrokes, bridgesOf } from './bridges.ts'
import { coverStrokes, sceneryOf, strokesOf, type Stroke } from './dress.ts'
import { labelsOf } from './labels.ts'
import { attributes, coinAt, ink, layer, NUMBERS, round, stationDrawn } from './layers.ts'
import { lineOf, sampled, STRAIGHT } from './line.ts'
import { ownId } from './own-id.ts'
import { writeRooms } from './rooms.ts'

/** A map as an SVG that opens again as the same document. */
export const writeMap = (map: MapDocument, id: string): string =>
  map.kind === 'rooms' ? writeRooms(map, id) : writeRoads(map, id)

/**
 * A map as the SVG of the maps that everybody has: layers, stations `node-i`, a path `path-i-j` for every move. What only
 * the document knows stands in attributes `data-…`; `openMap` makes the same document of it.
 */
function writeRoads(map: RoadMap, id: string): string {
  const lines = map.roads.map((road) => lineOf(map, road))
  const labels = labelsOf(map)
  const drawn = map.roads.map((road, index) => roadDrawn(map, road, lines[index]!.there))
  const font = `font-family="'Baloo 2', Nunito, sans-serif" font-weight="800" font-size="${NUMBERS}" text-anchor="middle"`
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${paper.width} ${paper.height}"${attributes({
      ...{ map: ownId(id), name: map.name, dress: map.dress, cover: map.cover },
      ...{ 'cm-per-unit': paper.cmPerUnit, 'plaza-cm': STRAIGHT, start: map.start, goal: map.goals[0] },
      ...{ goals: map.goals.join(' '), endless: map.endless && '', 'step-cost': map.stepCost },
      'length-counts': map.lengthCounts && '',
    })}>`,
    layer('scenery', [
      sceneryOf(
        map,
        lines.map(({ there }) => there),
      ),
    ]),
    layer('roads', [...drawn, ...bridgesDrawn(map, lines.map(({ there }) => there)), ...map.roads.map((road, index) => marksOn(road, lines[index]!.there))], 'fill="none" stroke-linecap="round" stroke-linejoin="round"'), // prettier-ignore
    layer(
      'covers',
      coversOf(
        map,
        lines.map(({ there }) => there),
      ),
    ),
    layer(
      'paths',
      map.roads.flatMap((road, index) => pathsOf(road, index, lines[index]!)),
      'fill="none"',
    ),
    layer(
      'stations',
      map.stations.map((station, number) => stationDrawn(station, number, { label: labels[number]! })),
      font,
    ),
    map.cover === 'fog' ? layer('fog', map.stations.map(fogOn)) : '',
    '</svg>',
    '',
  ].join('\n')
}

// ---- what is drawn ----

const stroke = (line: string, { colour, width, dash }: Stroke) =>
  `<path d="${line}" stroke="${colour}" stroke-width="${width}"${dash ? ` stroke-dasharray="${dash}" stroke-linecap="butt"` : ''}/>`

const roadDrawn = ({ dress }: RoadMap, road: MapRoad, line: string) =>
  strokesOf(dress)
    .map((one) => stroke(line, road.slip ? { ...one, colour: icy(one.colour) } : one))
    .join('')

/** A slippery road is of ice. */
export const icy = (colour: string) => (colour === ink ? '#3E7D8E' : '#DDF1F6')

/** The pieces of road that lead over another one, on rails. */
function bridgesDrawn({ dress }: RoadMap, lines: readonly string[]): string[] {
  const strokes = bridgeStrokes(dress)
  return bridgesOf(lines).map(
    ({ line }) => `<g stroke-linecap="butt">${strokes.map((one) => stroke(line, one)).join('')}</g>`,
  )
}

/** Arrows of a one-way road, the sign of a closed one, and what it pays. */
function marksOn({ oneWay, closed, reward }: MapRoad, line: string): string {
  const points = sampled(line)
  const arrows = oneWay ? [0.35, 0.65].map((share) => arrowAt(points, share)) : []
  const middle = points[Math.floor(points.length / 2)]!
  const sign = closed ? [signAt(middle, closed === 'both' || oneWay ? null : turned(points, closed))] : []
  return [
    ...arrows,
    ...sign,
    ...(reward ? [coinAt({ x: middle.x + 52, y: middle.y + 40 }, reward)] : []),
  ].join('')
}

function turned(points: readonly Point[], closed: 'there' | 'back') {
  return closed === 'there' ? points : points.toReversed()
}

/** A quarter turn has no angle here: the arrow is drawn along its road. */
function arrowAt(points: readonly Point[], share: number): string {
  const index = Math.min(points.length - 2, Math.max(1, Math.floor(points.length * share)))
  const [from, tip] = [points[index - 1]!, points[index + 1]!]
  const length = distance(from, tip) || 1
  const [x, y] = [(tip.x - from.x) / length, (tip.y - from.y) / length]
  const to = (along: number, aside: number) =>
    `${round(points[index]!.x + along * x - aside * y)} ${round(points[index]!.y + along * y + aside * x)}`
  const d = `M${to(-26, 0)}L${to(20, 0)}M${to(2, -15)}L${to(22, 0)}L${to(2, 15)}`
  return `<path d="${d}" stroke="#FFFFFF" stroke-width="16"/><path d="${d}" stroke="#1F67B3" stroke-width="9"/>`
}

/** `points`: where it closes one direction alone, the road in that direction. */
function signAt({ x, y }: Point, points: readonly Point[] | null): string {
  const plate = `<g transform="translate(${round(x)} ${round(y)})"><path d="M-15 -36h30l21 21v30l-21 21h-30l-21 -21v-30z" fill="#C9281F" stroke="#FFFFFF" stroke-width="5"/><rect x="-20" y="-7" width="40" height="14" rx="4" fill="#FFFFFF" stroke="none"/></g>`
  return points === null ? plate : arrowAt(points, 0.64) + plate
}

function coversOf({ cover, roads }: RoadMap, lines: readonly string[]): string[] {
  if (cover === undefined) return []
  const { colour, width } = coverStrokes[cover]
  const names = roads.map(({ from, to }) => `${Math.min(from, to)}-${Math.max(from, to)}`)
  return names.flatMap((name, index) =>
    names.indexOf(name) === index
      ? [`<path id="cover-${name}" d="${lines[index]}" fill="none" stroke="${colour}" stroke-width="${width}" stroke-linecap="round"/>`] // prettier-ignore
      : [],
  )
}

const fogOn = ({ x, y }: Point, station: number) =>
  `<circle id="fog-${station}" cx="${x}" cy="${y}" r="120" fill="#E6E3DA" fill-opacity=".92"/>`

// ---- what is read ----

function pathsOf(road: MapRoad, index: number, { there, back }: { there: string; back: string }): string[] {
  const { from, to, bends, oneWay, closed, reward, slip } = road
  const both = attributes({ reward, slip })
  const own = attributes({
    road: index,
    bends: bends.length > 0 ? bends.map(({ x, y }) => `${x} ${y}`).join(' ') : undefined,
    sign: closed,
  })
  const shut = (way: 'there' | 'back') =>
    closed === 'both' || closed === way ? attributes({ closed: '' }) : ''
  return [
    `<path id="path-${from}-${to}" d="${there}"${own}${both}${shut('there')}/>`,
    oneWay ? '' : `<path id="path-${to}-${from}" d="${back}"${both}${shut('back')}/>`,
  ]
}
