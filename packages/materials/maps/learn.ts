import { Course, layOutWorld, shortestWay } from '@botgarten/learning/q-learning'
import { inScene, learningIn, type LearningOutline } from '@botgarten/programs'
import type { Document } from '@botgarten/lab'
import { drawWay } from './drawn.ts'
import type { MapFile } from './types.ts'

/** What of a program a learning depends on, as one text. */
export const learningKey = ({ blocks: _, ...learning }: LearningOutline): string => JSON.stringify(learning)

/** A course of what a program wants learned, at its beginning. @throws RangeError where the map has no such station */
export function courseOf(
  outline: LearningOutline,
  { map, goalReward, stepCost }: MapFile,
  seed: number,
): Course {
  const { start, goal, closed, settings, episodes, moves } = outline
  const pay = { ...(goalReward !== undefined && { goalReward }), ...(stepCost !== undefined && { stepCost }) }
  const world = layOutWorld({ map, start, goal, closed, ...pay })
  return new Course(world, settings, seed, { episodes, moves })
}

/** Sections of the shortest way from start to goal; null: closed roads leave none. */
export function sectionsOf({ learner: { world } }: Course): number | null {
  const stations = shortestWay(world)
  return stations === null ? null : stations - 1
}

/**
 * What a program that learns finds when it drives: everything is learned, the way lies on the floor and the robot
 * stands on its start. The same document where the program learns nothing, or has not learned a way.
 */
export function withLearnedWay(
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
  const { stations } = course.way()
  if (!stations || stations.length < 2) return document
  return { ...document, world: inScene(document.world, drawWay(map, stations).scene) }
}
