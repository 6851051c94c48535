import {
  isMap,
  mostOfMap as most,
  paper,
  type MapDocument,
  type MapRoad,
  type RoadMap,
} from '@botgarten/programs'
import { cleanDrawing } from '../clean.ts'
import { elementsOf, type Element } from '../elements.ts'
import { numbersIn } from '../path.ts'
import { distance, type Point } from '../point.ts'
import { readMap } from '../readMap.ts'
import type { MapFile, MapProblem } from '../types.ts'
import { photoAddress } from './dress.ts'
import { emptyMap, MARGIN } from './edit.ts'
import { sampled } from './line.ts'

export type OpenedMap =
  | {
      readonly map: MapDocument
      /** What was left out, and what looks like a station or a road and is none. */
      readonly warnings: readonly MapProblem[]
      /** What else was drawn there, as an SVG to lie under the roads; null: nothing. */
      readonly picture: string | null
    }
  | { readonly map: null; readonly problems: readonly MapProblem[]; readonly warnings: readonly MapProblem[] }

/**
 * A map to draw on, from an SVG. One that `writeMap` wrote becomes the same document; of another one the stations and
 * roads are taken, fitted to the paper, and all the rest is a picture under them. A drawing without names of stations and
 * roads is a picture alone. Everything that is wrong is named.
 */
export function openMap(text: string, name: string): OpenedMap {
  const own = ownIn(text)
  if (own !== null) return { map: own, warnings: [], picture: null }
  const cleaned = cleanDrawing(text)
  if ('problem' in cleaned) return { map: null, problems: [cleaned.problem], warnings: [] }
  const { plan, picture, removed } = cleaned
  const { map: file, problems, warnings: strange } = readMap(plan)
  const warnings = [...strange, ...removed.map((name): MapProblem => ({ kind: 'removed', facts: { name } }))]
  if (file !== null) {
    const tooMany = tooManyIn(file)
    if (tooMany) return { map: null, problems: [tooMany], warnings }
    return { map: drawnFrom(file, name), warnings, picture }
  }
  const isPicture =
    picture !== null && strange.length === 0 && problems.every(({ kind }) => kind === 'noStations')
  if (isPicture) return { map: emptyMap(name.slice(0, most.name)), warnings, picture }
  return { map: null, problems: [...problems, ...strange], warnings: [] }
}

function tooManyIn({ stations, grid, map }: MapFile): MapProblem | null {
  if (grid) return { kind: 'gridToDraw', facts: {} }
  const count = stations.length
  if (count > most.stations) return { kind: 'tooManyStations', facts: { count, most: most.stations } }
  const roads = map.actions.flat().length
  return roads > 2 * most.roads ? { kind: 'tooManyRoads', facts: { count: roads, most: most.roads } } : null
}

// ---- our own ----

function ownIn(text: string): MapDocument | null {
  if (!/ data-(?:dress|rooms)="/.test(text)) return null
  if (readMap(text).map === null) return null
  const read = elementsOf(text)
  const elements = 'elements' in read ? read.elements : []
  const root = elements[0]?.attributes
  if (!root) return null
  const map = root['data-rooms'] === undefined ? documentFrom(elements, root) : roomsFrom(root)
  return isMap(map) ? map : null
}

function roomsFrom(root: Element['attributes']): unknown {
  const wind = root['data-wind']
  return {
    ...{ kind: 'rooms', name: root['data-name'] ?? '', rows: (root['data-grid'] ?? '').split('/') },
    ...(wind !== undefined && { wind: numbersIn(wind) }),
  }
}

const given = (attributes: Element['attributes'], name: string, as: (text: string) => unknown = Number) => {
  const text = attributes[`data-${name}`]
  const key = name.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase())
  return text === undefined ? {} : { [key]: as(text) }
}

function documentFrom(elements: readonly Element[], root: Element['attributes']): unknown {
  const nodes = byNumber(elements, /^node-(\d+)$/, ({ attributes: { id } }) => Number(id!.slice(5)))
  const paths = byNumber(elements, /^path-\d+-\d+$/, ({ attributes }) => Number(attributes['data-road']))
  const both = new Set(elements.flatMap(({ attributes: { id } }) => id ?? []))
  return {
    ...{ kind: 'roads', name: root['data-name'] ?? '', dress: root['data-dress'] },
    ...given(root, 'cover', String),
    ...photoIn(elements),
    stations: nodes.map(({ attributes }) => ({
      ...placeIn(attributes['transform'] ?? ''),
      ...given(attributes, 'name', String),
      ...given(attributes, 'reward'),
    })),
    roads: paths.map(({ attributes }) => {
      const [, from, to] = attributes['id']!.split('-').map(Number) as [number, number, number]
      const sign = attributes['data-sign']
      return {
        ...{ from, to, bends: pointsIn(attributes['data-bends'] ?? '') },
        ...(!both.has(`path-${to}-${from}`) || isOwn(paths, to, from) ? { oneWay: true } : {}),
        ...(sign === undefined ? {} : { closed: sign }),
        ...given(attributes, 'reward'),
        ...given(attributes, 'slip'),
      }
    }),
    start: Number(root['data-start']),
    goals: numbersIn(root['data-goals'] ?? '') ?? [],
    ...(root['data-endless'] === undefined ? {} : { endless: true }),
    ...given(root, 'step-cost'),
    ...(root['data-length-counts'] === undefined ? {} : { lengthCounts: true }),
  }
}

function photoIn(elements: readonly Element[]) {
  const address = elements.find(({ name }) => name === 'image')?.attributes['href'] ?? ''
  return address.startsWith(photoAddress('')) ? { photo: address.slice(photoAddress('').length) } : {}
}

/** Elements of these ids in the order of their numbers; those without a number are left out. */
function byNumber(elements: readonly Element[], ids: RegExp, numberOf: (element: Element) => number) {
  return elements
    .filter((element) => ids.test(element.attributes['id'] ?? '') && Number.isFinite(numberOf(element)))
    .toSorted((a, b) => numberOf(a) - numberOf(b))
}

/** Is the way back a road of its own? */
const isOwn = (paths: readonly Element[], from: number, to: number) =>
  paths.some(({ attributes: { id } }) => id === `path-${from}-${to}`)

function placeIn(transform: string): Point {
  const [x = NaN, y = NaN] = numbersIn(transform.replace(/^translate\((.*)\)$/, '$1')) ?? []
  return { x, y }
}

function pointsIn(text: string): Point[] {
  const numbers = numbersIn(text) ?? []
  return Array.from({ length: numbers.length / 2 }, (_, k) => ({
    x: numbers[2 * k]!,
    y: numbers[2 * k + 1]!,
  }))
}

// ---- that of another ----

function drawnFrom(file: MapFile, name: string): RoadMap {
  const fit = fitted(file)
  const { actions } = file.map
  const roads = actions.flatMap((list, from) =>
    list.flatMap(({ to, reward, slip }): MapRoad[] => {
      const back = actions[to]!.some((move) => move.to === from)
      if (back && to < from) return []
      const bends = bendsOf(sampled(file.roads[`${from}-${to}`] ?? '').map(fit))
      return [{ ...{ from, to, bends }, ...(back ? {} : { oneWay: true }), ...kept(reward, slip) }]
    }),
  )
  const { start = 0, goal = Math.max(0, file.stations.length - 1) } = file
  return {
    ...{ kind: 'roads', name: name.slice(0, most.name), dress: 'meadow' },
    stations: file.stations.map((place, station) => ({
      ...fit(place),
      ...(place.name !== undefined && { name: place.name.slice(0, most.name) }),
      ...kept(file.map.rewards?.[station]),
    })),
    ...{ roads: roads.slice(0, most.roads), start, goals: [...new Set([goal, ...(file.map.goals ?? [])])] },
  }
}

const kept = (reward?: number, slip?: number) => ({
  ...(reward !== undefined && reward !== 0 && { reward: Math.max(-100, Math.min(100, reward)) }),
  ...(slip ? { slip } : {}),
})

/** From the drawing to the paper: as large as it fits. */
function fitted({ size, stations }: MapFile): (point: Point) => Point {
  const width = size.width || Math.max(1, ...stations.map(({ x }) => x))
  const height = size.height || Math.max(1, ...stations.map(({ y }) => y))
  const scale = Math.min(paper.width / width, paper.height / height)
  const [left, top] = [(paper.width - width * scale) / 2, (paper.height - height * scale) / 2]
  const within = (value: number, most: number) => Math.round(Math.min(most - MARGIN, Math.max(MARGIN, value)))
  return ({ x, y }) => ({
    x: within(left + x * scale, paper.width),
    y: within(top + y * scale, paper.height),
  })
}

/** A line bends where it is farthest from what is drawn so far: Ramer 1972, with so many bends at most. */
function bendsOf(points: readonly Point[]): Point[] {
  const corners = [0, points.length - 1]
  for (let count = 0; count < most.bends; count++) {
    const far = corners.slice(1).map((end, index) => farthest(points, corners[index]!, end))
    const worst = far.reduce((a, b) => (b.gap > a.gap ? b : a), { gap: 0, index: 0 })
    if (worst.gap < 12) break
    corners.push(worst.index)
    corners.sort((a, b) => a - b)
  }
  return corners.slice(1, -1).map((index) => points[index]!)
}

function farthest(points: readonly Point[], from: number, to: number) {
  const [a, b] = [points[from]!, points[to]!]
  const length = distance(a, b) || 1
  let worst = { gap: 0, index: from }
  for (let index = from + 1; index < to; index++) {
    const p = points[index]!
    const gap = Math.abs((b.x - a.x) * (a.y - p.y) - (a.x - p.x) * (b.y - a.y)) / length
    if (gap > worst.gap) worst = { gap, index }
  }
  return worst
}
