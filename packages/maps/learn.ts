import {
  Course,
  layOutWorld,
  lengthOf,
  shortestLength,
  shortestPath,
  type QMap,
} from '@botgarten/learning/q-learning'
import { inScene, learningIn, type LearningOutline, type Program, type Project } from '@botgarten/programs'
import type { Learned as InPython } from '@botgarten/programs/python'
import { drawWay } from './drawn.ts'
import { lessonOf } from './lesson.ts'
import { LENGTH_COST, type MapFile } from './types.ts'
import { legsOf, wayFault } from './way.ts'

/** What of a program a learning depends on, as one text. */
export const learningKey = ({ blocks: _, ...learning }: LearningOutline): string => JSON.stringify(learning)

/** A course of what a program wants learned, at its beginning. @throws RangeError where the map has no such station */
export function courseOf(
  outline: LearningOutline,
  { map, goalReward, stepCost, lengthCost }: MapFile,
  seed: number,
): Course {
  const { start, goal, closed, settings, episodes, moves, pay = {} } = outline
  const world = layOutWorld({
    ...{ map: withOwnRewards(map, pay.own ?? {}), start, goal, closed },
    ...(goalReward !== undefined && { goalReward }),
    stepCost: (stepCost ?? 0) + (pay.step ?? 0),
    ...((pay.length || lengthCost !== undefined) && { lengthCost: LENGTH_COST }),
  })
  return new Course(world, settings, seed, { episodes, steps: moves })
}

/** What is paid on arrival at stations and on roads, on top of what the map pays itself. */
function withOwnRewards(map: QMap, own: { readonly [place: string]: number }): QMap {
  if (Object.keys(own).length === 0) return map
  const rewards = map.actions.map((_, station) => (map.rewards?.[station] ?? 0) + (own[station] ?? 0))
  const moves = map.actions.map((list, from) =>
    list.map((move) => ({ ...move, reward: (move.reward ?? 0) + (own[`${from}-${move.to}`] ?? 0) })),
  )
  return { ...map, actions: moves, rewards }
}

/** Is this a shortest way there is: by sections, or by length where length counts? */
export function isShortest({ learner: { world } }: Course, stations: readonly number[]): boolean {
  if (world.task.lengthCost) return lengthOf(world, stations) <= (shortestLength(world) ?? 0) + 1e-6
  return stations.length === shortestPath(world)
}

/** Sections of the shortest way from start to goal; null: closed roads leave none. */
export function sectionsOf({ learner: { world } }: Course): number | null {
  const stations = shortestPath(world)
  return stations === null ? null : stations - 1
}

/**
 * What a program that learns finds when it drives: everything is learned, the way lies on the floor and the robot
 * stands on its start. The same document where the program learns nothing, or has not learned a way.
 */
export function withLearnedWay<Document extends Pick<Project, 'programs' | 'world'>>(
  document: Document,
  mapNamed: (id: string) => MapFile | null,
  seed = 1,
): Document {
  const [robot] = document.world.robots
  const outline =
    robot && learningIn(document.programs[robot.program] ?? { stacks: [], config: { stacks: [] } })
  const map = outline?.blocks.draw === undefined ? null : mapNamed(outline.map)
  if (!robot || !outline || !map) return document
  const course = courseOf(outline, map, seed)
  course.advance(outline.moves)
  const { states: stations } = course.way()
  if (!stations || stations.length < 2 || wayFault(map, stations) !== null) return document
  return { ...document, world: inScene(document.world, drawWay(map, stations).scene) }
}

/**
 * What a program has learned by trying, as its Python takes it along; nothing where it learns nothing or found no way.
 * @param seed, moves as the project's `Learned` says; all of it from seed 1 where nothing is said
 */
export function learnedFor(
  program: Program,
  mapNamed: (id: string) => MapFile | null,
  { seed, moves }: { readonly seed: number; readonly moves: number } = { seed: 1, moves: Infinity },
): InPython {
  const outline = learningIn(program)
  const map = outline && mapNamed(outline.map)
  if (!outline || !map) return {}
  const course = courseOf(outline, map, seed)
  const lesson = lessonOf(course, map)
  const going = lesson ? { lesson } : {}
  if (moves === 0) return going
  course.advance(Math.min(outline.moves, moves))
  const { states: stations } = course.way()
  if (!stations || stations.length < 2) return going
  return { way: legsOf(map, stations), table: tableOf(course), ...going }
}

/** Q by station and by the next one. */
function tableOf({ learner: { world, q } }: Course): InPython['table'] {
  const { first, meant } = world
  const rows = Array.from({ length: world.states }, (_, state) => {
    const actions = Array.from({ length: first[state + 1]! - first[state]! }, (_, k) => first[state]! + k)
    return [state, Object.fromEntries(actions.map((action) => [meant[action]!, q[action]!]))] as const
  })
  return Object.fromEntries(rows.filter(([, row]) => Object.keys(row).length > 0))
}
