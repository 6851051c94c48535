import { type Action } from '@botgarten/learning/q-learning'
import { elementsOf, type Element } from './elements.ts'
import { gridIn } from './grid.ts'
import { numbersIn } from './path.ts'
import { keep, numberIn, problem, sizeOf } from './read-number.ts'
import { distance, type Point } from './point.ts'
import { dataOf, roadIn, type ReadRoad } from './road.ts'
import { placeOf, type Place } from './station.ts'
import { LENGTH_COST, type MapFile, type MapPlace, type MapProblem } from './types.ts'

const MOST_CHARACTERS = 1_000_000
const MOST_STATIONS = 500
/** Of the name of a station. */
const MOST_LETTERS = 60
/** Characters of the path data of all roads together. */
const MOST_DATA = 60_000

export type ReadMap = (
  | { readonly map: MapFile; readonly problems: readonly [] }
  | { readonly map: null; readonly problems: readonly MapProblem[] }
) & {
  /** What looks like a station or a road and is none. */
  readonly warnings: readonly MapProblem[]
}

/** A road of the drawing between two stations. */
interface Between {
  readonly name: string
  readonly from: number
  readonly to: number
  readonly read: ReadRoad
  readonly attributes: Element['attributes']
}

/**
 * Reads a map from an SVG: stations `node-i`, numbered from 0 without a gap (where they are: see `placeOf`), and a path
 * `path-i-j` for every allowed move; or a grid by the root's `data-grid` (rows joined by `/`). All broken rules are named.
 */
export function readMap(text: string): ReadMap {
  if (text.length > MOST_CHARACTERS) return broken([problem('tooLarge', { most: MOST_CHARACTERS })])
  const read = elementsOf(text)
  if ('problem' in read) return broken([read.problem])
  const { elements, unsafe } = read
  const [root] = elements
  if (root?.name !== 'svg') return broken([problem('noDrawing', {})])
  const problems: MapProblem[] = []
  if (unsafe !== null) problems.push(problem('unsafe', { name: unsafe }))
  const ids = elementsById(elements, problems)
  const warnings = [...ids.keys()].filter(isStrange).map((name) => problem('strangeId', { name }))
  const numbers = numbersOf(root, problems)
  const size = sizeOf(root)
  const roads = roadsIn(ids, problems)
  const stations = stationsIn({ elements, ids, roads, size }, problems)
  const laid =
    root.attributes['data-grid'] === undefined
      ? {
          map: {
            actions: actionsIn(roads, stations, problems),
            ...rewardsIn(ids, stations.length, problems),
            ...goalsIn(root, stations.length, problems),
          },
        }
      : gridIn(root.attributes, stations, problems)
  if (problems.length > 0 || laid === null) return broken(problems, warnings)
  const lines = roads.flatMap(({ from, to, read }) =>
    'line' in read ? [[`${from}-${to}`, read.line] as const] : [],
  )
  return {
    map: {
      ...{ id: root.attributes['data-map'] ?? '', size, roads: Object.fromEntries(lines) },
      ...{ stations: stations.map((place, station) => placeIn(place, ids.get(`node-${station}`)!)) },
      ...{ ...numbers, ...laid },
    },
    ...{ problems: [], warnings },
  }
}

const placeIn = ({ x, y }: Place, { attributes }: Element): MapPlace => {
  const name = attributes['data-name']?.slice(0, MOST_LETTERS)
  return name ? { x, y, name } : { x, y }
}

const broken = (problems: readonly MapProblem[], warnings: readonly MapProblem[] = []): ReadMap => ({
  ...{ map: null, problems, warnings },
})

const stationId = /^node-(0|[1-9]\d*)$/
const roadId = /^path-(0|[1-9]\d*)-(0|[1-9]\d*)$/
/** Meant as a station or a road, to all appearances. */
const isStrange = (id: string) => /^(node|path)[-_ ]/i.test(id) && !stationId.test(id) && !roadId.test(id)

function elementsById(elements: readonly Element[], problems: MapProblem[]): Map<string, Element> {
  const ids = new Map<string, Element>()
  for (const element of elements) {
    const { id } = element.attributes
    if (id === undefined) continue
    if (ids.has(id)) problems.push(problem('idTwice', { name: id }))
    ids.set(id, element)
  }
  return ids
}

function numbersOf({ attributes }: Element, problems: MapProblem[]) {
  const read = (name: string) => numberIn(attributes[name], name, problems)
  return {
    cmPerUnit: read('data-cm-per-unit') ?? 1,
    plazaCm: read('data-plaza-cm') ?? 15,
    ...keep('start', read('data-start')),
    ...keep('goal', read('data-goal')),
    ...keep('goalReward', read('data-goal-reward')),
    ...keep('stepCost', read('data-step-cost')),
    ...(attributes['data-length-counts'] !== undefined && { lengthCost: LENGTH_COST }),
  }
}

function roadsIn(ids: ReadonlyMap<string, Element>, problems: MapProblem[]): readonly Between[] {
  const roads = [...ids].flatMap(([name, element]) => {
    const [, from, to] = roadId.exec(name)?.map(Number) ?? []
    return from === undefined || to === undefined ? [] : [{ name, from, to, element }]
  })
  let room = MOST_DATA
  const late = roads.find(({ element }) => (room -= dataOf(element).length) < 0)
  if (late) {
    problems.push(problem('pathsLong', { name: late.name, most: MOST_DATA }))
    return []
  }
  return roads.map(({ element, ...road }) => ({
    ...{ ...road, read: roadIn(road.name, element), attributes: element.attributes },
  }))
}

/** Goals beside the first, and whether goals end an attempt. */
function goalsIn({ attributes }: Element, count: number, problems: MapProblem[]) {
  const text = attributes['data-goals']
  const goals = text === undefined ? [] : numbersIn(text)
  if (goals === null || !goals.every((goal) => Number.isInteger(goal) && goal >= 0 && goal < count))
    problems.push(problem('number', { name: 'data-goals', value: text ?? '' }))
  return {
    ...(goals && goals.length > 1 && { goals: goals.slice(1) }),
    ...(attributes['data-endless'] !== undefined && { endless: true }),
  }
}

interface Drawing {
  readonly elements: readonly Element[]
  readonly ids: ReadonlyMap<string, Element>
  readonly roads: readonly Between[]
  readonly size: MapFile['size']
}

function stationsIn({ elements, ids, roads, size }: Drawing, problems: MapProblem[]): readonly Place[] {
  const count = [...ids.keys()].filter((id) => stationId.test(id)).length
  if (count === 0) problems.push(problem('noStations', {}))
  if (count > MOST_STATIONS) {
    problems.push(problem('tooManyStations', { count, most: MOST_STATIONS }))
    return []
  }
  const ends = endsOf(roads)
  const diagonal = Math.sqrt(size.width * size.width + size.height * size.height)
  return Array.from({ length: count }, (_, station) => {
    const name = `node-${station}`
    const element = ids.get(name)
    if (!element) problems.push(problem('stationMissing', { name, count }))
    else if (element.unreadTransform !== null)
      problems.push(problem('transform', { name, value: element.unreadTransform }))
    else {
      const place = placeOf(element, insideOf(elements, element), ends.get(station) ?? [], diagonal)
      if (place) return place
      problems.push(problem('stationPlace', { name }))
    }
    // It is nowhere, and that is said: its roads are not blamed for it.
    return { x: 0, y: 0, reach: Infinity }
  })
}

/** Where the roads of each station end. */
function endsOf(roads: readonly Between[]): ReadonlyMap<number, readonly Point[]> {
  const ends = new Map<number, Point[]>()
  const note = (station: number, end: Point) => {
    const known = ends.get(station)
    if (known) known.push(end)
    else ends.set(station, [end])
  }
  for (const { from, to, read } of roads) {
    if ('problem' in read) continue
    note(from, read.from)
    note(to, read.to)
  }
  return ends
}

function insideOf(elements: readonly Element[], element: Element): readonly Element[] {
  const first = elements.indexOf(element) + 1
  const end = elements.findIndex(({ depth }, index) => index >= first && depth <= element.depth)
  return elements.slice(first, end < 0 ? elements.length : end)
}

function actionsIn(
  roads: readonly Between[],
  stations: readonly Place[],
  problems: MapProblem[],
): readonly (readonly Action[])[] {
  const actions: Action[][] = stations.map(() => [])
  for (const { name, from, to, read, attributes } of roads) {
    const nowhere = [from, to].find((station) => station >= stations.length)
    if (nowhere !== undefined) problems.push(problem('pathToNowhere', { name, station: nowhere }))
    else if (from === to) problems.push(problem('pathToItself', { name }))
    else if ('problem' in read) problems.push(read.problem)
    else {
      const late = [from, to].find((station, last) => {
        const { reach, ...place } = stations[station]!
        return distance(last ? read.to : read.from, place) > reach
      })
      if (late !== undefined) problems.push(problem('pathEnd', { name, station: late }))
      const reward = numberIn(attributes['data-reward'], `${name} data-reward`, problems)
      const slip = numberIn(attributes['data-slip'], `${name} data-slip`, problems)
      if (slip !== undefined && !(slip >= 0 && slip <= 1))
        problems.push(problem('number', { name: `${name} data-slip`, value: slip }))
      // A sign stands on it: the road is there, and nobody may take it.
      if (attributes['data-closed'] !== undefined) continue
      actions[from]!.push({ to, length: read.length, ...keep('reward', reward), ...keep('slip', slip) })
    }
  }
  return actions.map((list) => list.toSorted((a, b) => a.to - b.to))
}

function rewardsIn(ids: ReadonlyMap<string, Element>, count: number, problems: MapProblem[]) {
  const found = Array.from({ length: count }, (_, station) => {
    const name = `node-${station}`
    return [
      station,
      numberIn(ids.get(name)?.attributes['data-reward'], `${name} data-reward`, problems),
    ] as const
  }).filter(([, reward]) => reward !== undefined)
  return found.length === 0 ? {} : { rewards: Object.fromEntries(found) as { [station: number]: number } }
}
