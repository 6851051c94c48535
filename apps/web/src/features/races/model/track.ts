import maps from 'content:maps'
import { layOutWorld, type QWorld, type Task } from '@botgarten/learning/q-learning'
import type { MapFile } from '@botgarten/maps'
import { learningIn, type Project } from '@botgarten/programs'
import { mapName } from '#figures/map/names.ts'
import { courseOn, loadStage, type Stage } from '#figures/map/stage.ts'
import { open } from '#storage/projects.ts'

/** The map of a race and the learning task on it. */
export interface Track {
  readonly stage: Stage
  readonly task: Task
  readonly world: QWorld
  readonly name: string
  /** The project that the map belongs to; null: a built-in map. */
  readonly project: string | null
}

interface Asked {
  readonly project: string | null
  readonly map: string | null
}

/** The first map of a race: Q and SARSA differ most there. */
const FIRST = 'cliff'

/** @returns null if this device has no such project, its program does not learn, or the map is missing */
export async function openTrack({ project: id, map }: Asked): Promise<Track | null> {
  if (id === null) return givenTrack(map ?? FIRST)
  const found = await open(id)
  return found && ownTrack(id, found.project)
}

/** Learning task of the first program of a project that has one. */
async function ownTrack(id: string, project: Project): Promise<Track | null> {
  const outline = Object.values(project.programs)
    .map(learningIn)
    .find((one) => one !== null)
  const stage = outline && (await loadStage(outline.map, project.maps))
  const world = stage && courseOn(stage, outline, 1)?.learner.world
  if (!stage || !world) return null
  return { stage, task: world.task, world, name: mapName(outline.map, project.maps), project: id }
}

/** Start and goal of a map: its own, or those of its card. */
const ends: { readonly [map: string]: Pick<Task, 'start' | 'goal' | 'closed'> } = {
  railway: { start: 3, goal: 1, closed: [[3, 2], [2, 3]] },
  forest: { start: 0, goal: 7, closed: [[4, 6]] },
  city: { start: 0, goal: 15, closed: [[16, 15]] },
} // prettier-ignore

/** The learning task of a built-in map. */
export function taskOn(
  id: string,
  { map, start = 0, goal = map.actions.length - 1, goalReward, stepCost, lengthCost }: MapFile,
): Task {
  return {
    ...{ map, start, goal, ...ends[id] },
    ...(goalReward !== undefined && { goalReward }),
    ...(stepCost !== undefined && { stepCost }),
    ...(lengthCost !== undefined && { lengthCost }),
  }
}

async function givenTrack(id: string): Promise<Track | null> {
  const stage = maps.maps.includes(id) ? await loadStage(id) : null
  if (!stage) return null
  const task = taskOn(id, stage.map)
  return { stage, task, world: layOutWorld(task), name: mapName(id), project: null }
}

/** Maps that can be raced on. */
export const tracks = (): readonly string[] => maps.maps
