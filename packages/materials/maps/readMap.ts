import { gridMap, type Move } from '@botgarten/learning/q-learning'
import { elementsOf, type Element } from './elements.ts'
import { distance, readPath } from './path.ts'
import type { MapFile, MapProblem } from './types.ts'

const MOST_CHARACTERS = 1_000_000
const MOST_STATIONS = 500
/** A road ends at its station's centre, in units of the drawing. */
const NEAR = 1

export type ReadMap =
  | { readonly map: MapFile; readonly problems: readonly [] }
  | { readonly map: null; readonly problems: readonly MapProblem[] }

/**
 * Reads a map from an SVG: stations `node-i`, numbered from 0 without a gap and placed by `transform="translate(x y)"`,
 * and a path `path-i-j` for every allowed move; or a grid by the root's `data-grid` (rows joined by `/`). All broken
 * rules are named.
 */
export function readMap(text: string): ReadMap {
  if (text.length > MOST_CHARACTERS) return broken([problem('tooLarge', { most: MOST_CHARACTERS })])
  const read = elementsOf(text)
  if ('line' in read) return broken([problem('notXml', { line: read.line })])
  const { elements, unsafe } = read
  const [root] = elements
  if (root?.name !== 'svg') return broken([problem('noDrawing', {})])
  const problems: MapProblem[] = []
  if (unsafe !== null) problems.push(problem('unsafe', { name: unsafe }))
  const ids = elementsById(elements, problems)
  const numbers = numbersOf(root, problems)
  const stations = stationsIn(ids, problems)
  const laid =
    root.attributes['data-grid'] === undefined
      ? { map: { moves: movesIn(ids, stations, problems), ...rewardsIn(ids, stations.length, problems) } }
      : gridIn(root, stations.length, problems)
  if (problems.length > 0 || laid === null) return broken(problems)
  const drawn = { size: sizeOf(root), roads: roadsIn(ids) }
  return {
    map: { id: root.attributes['data-map'] ?? '', stations, ...drawn, ...numbers, ...laid },
    problems: [],
  }
}

const problem = (kind: MapProblem['kind'], facts: MapProblem['facts']): MapProblem => ({ kind, facts })
const broken = (problems: readonly MapProblem[]): ReadMap => ({ map: null, problems })

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
  }
}

function sizeOf({ attributes }: Element) {
  const [, , width = 0, height = 0] = (attributes['viewBox'] ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number)
  return { width, height }
}

const roadsIn = (ids: ReadonlyMap<string, Element>): { readonly [name: string]: string } =>
  Object.fromEntries(
    [...ids].flatMap(([id, { attributes }]) =>
      id.startsWith('path-') ? [[id.slice('path-'.length), attributes['d'] ?? '']] : [],
    ),
  )

const keep = <Name extends string>(name: Name, value: number | undefined) =>
  (value === undefined ? {} : { [name]: value }) as { [key in Name]?: number }

function numberIn(text: string | undefined, name: string, problems: MapProblem[]): number | undefined {
  if (text === undefined) return undefined
  const value = Number(text)
  if (text.trim() !== '' && Number.isFinite(value)) return value
  problems.push(problem('number', { name, value: text }))
  return undefined
}

function stationsIn(ids: ReadonlyMap<string, Element>, problems: MapProblem[]) {
  const found = [...ids.keys()].flatMap((id) => /^node-(\d+)$/.exec(id)?.[1] ?? []).map(Number)
  if (found.length === 0) problems.push(problem('noStations', {}))
  if (found.length > MOST_STATIONS) {
    problems.push(problem('tooManyStations', { count: found.length, most: MOST_STATIONS }))
    return []
  }
  return found.map((_, station) => {
    const element = ids.get(`node-${station}`)
    if (!element) problems.push(problem('stationMissing', { name: `node-${station}`, count: found.length }))
    const at = /^translate\(([-\d.]+)[ ,]+([-\d.]+)\)$/.exec(element?.attributes['transform'] ?? '')
    if (element && !at) problems.push(problem('stationPlace', { name: `node-${station}` }))
    return { x: Number(at?.[1] ?? 0), y: Number(at?.[2] ?? 0) }
  })
}

function movesIn(
  ids: ReadonlyMap<string, Element>,
  stations: readonly { readonly x: number; readonly y: number }[],
  problems: MapProblem[],
): readonly (readonly Move[])[] {
  const moves: Move[][] = stations.map(() => [])
  for (const [name, { attributes }] of ids) {
    const ends = /^path-(\d+)-(\d+)$/.exec(name)
    if (!ends) continue
    const [from, to] = [Number(ends[1]), Number(ends[2])]
    const nowhere = [from, to].find((station) => station >= stations.length)
    if (nowhere !== undefined) problems.push(problem('pathToNowhere', { name, station: nowhere }))
    else if (from === to) problems.push(problem('pathToItself', { name }))
    else {
      const shape = readPath(attributes['d'] ?? '')
      if (!shape) problems.push(problem('pathShape', { name }))
      else if (distance(shape.from, stations[from]!) > NEAR)
        problems.push(problem('pathEnd', { name, station: from }))
      else if (distance(shape.to, stations[to]!) > NEAR)
        problems.push(problem('pathEnd', { name, station: to }))
      else {
        const reward = numberIn(attributes['data-reward'], `${name} data-reward`, problems)
        moves[from]!.push({ to, length: shape.length, ...keep('reward', reward) })
      }
    }
  }
  return moves.map((list) => list.toSorted((a, b) => a.to - b.to))
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

function gridIn({ attributes }: Element, stations: number, problems: MapProblem[]) {
  const rows = attributes['data-grid']!.split('/')
  const surefooted = numberIn(attributes['data-surefooted'], 'data-surefooted', problems)
  const cliffReward = numberIn(attributes['data-cliff-reward'], 'data-cliff-reward', problems)
  try {
    const grid = gridMap(rows, { ...keep('surefooted', surefooted), ...keep('cliffReward', cliffReward) })
    if (grid.map.moves.length === stations) return grid
    problems.push(problem('stationMissing', { name: `node-${stations}`, count: grid.map.moves.length }))
  } catch (error) {
    problems.push(problem('grid', { why: (error as RangeError).message }))
  }
  return null
}
