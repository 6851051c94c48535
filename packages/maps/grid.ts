import { gridMap, type Grid } from '@botgarten/learning/q-learning'
import type { Element } from './elements.ts'
import { keep, numberIn, problem } from './read-number.ts'
import { numbersIn } from './path.ts'
import type { Point } from './point.ts'
import type { MapFile, MapProblem } from './types.ts'

type Laid = Pick<MapFile, 'map' | 'start' | 'goal' | 'grid' | 'roads'>

/** A grid as the root's `data-grid` says it: rows joined by `/`. Null: a rule is broken, and named. */
export function gridIn(
  attributes: Element['attributes'],
  stations: readonly Point[],
  problems: MapProblem[],
): Laid | null {
  const rows = attributes['data-grid']!.split('/')
  const one = (name: string) => numberIn(attributes[name], name, problems)
  const list = (name: string) => (attributes[name] === undefined ? undefined : numbersIn(attributes[name]))
  const [wind, chances] = [list('data-wind'), list('data-chances')]
  if (wind === null) problems.push(problem('number', { name: 'data-wind', value: attributes['data-wind']! }))
  if (chances === null)
    problems.push(problem('number', { name: 'data-chances', value: attributes['data-chances']! }))
  if (wind === null || chances === null) return null
  try {
    const grid = gridMap(rows, {
      ...keep('surefooted', one('data-surefooted')),
      ...keep('cliffReward', one('data-cliff-reward')),
      ...keep('goalReward', one('data-goal-reward')),
      ...(wind && { wind }),
      ...(chances && { chances }),
    })
    const count = grid.map.actions.length
    if (count === stations.length) return laidOut(grid, rows.join(''), wind ?? [], stations)
    problems.push(problem('stationMissing', { name: `node-${stations.length}`, count }))
  } catch (error) {
    problems.push(problem('grid', { why: (error as RangeError).message }))
  }
  return null
}

function laidOut(grid: Grid, letters: string, wind: readonly number[], stations: readonly Point[]): Laid {
  const { map, start, goal, columns, rows } = grid
  const floors = map.actions.length / letters.length
  return { map, start, goal, grid: { columns, rows, letters, floors, wind }, roads: linesOf(map, stations) }
}

/** Straight lines between the middles of rooms, for every move that leads into another room. */
function linesOf({ actions }: MapFile['map'], stations: readonly Point[]): MapFile['roads'] {
  const at = (station: number) => `${stations[station]!.x} ${stations[station]!.y}`
  return Object.fromEntries(
    actions.flatMap((moves, from) =>
      moves
        .flatMap(({ to, outcomes = [] }) => [to, ...outcomes.map((outcome) => outcome.to)])
        .filter((to) => to !== from)
        .map((to) => [`${from}-${to}`, `M${at(from)}L${at(to)}`] as const),
    ),
  )
}
