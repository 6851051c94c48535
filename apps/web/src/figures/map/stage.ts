import maps from 'content:maps'
import type { Course } from '@botgarten/learning/q-learning'
import { ownMapIn } from '@botgarten/blocks'
import { courseOf, readMap, type MapFile } from '@botgarten/maps'
import type { LearningOutline, Project } from '@botgarten/programs'
import { takeApart, type Picture } from './picture.ts'
import { roadsOf, type Road } from './roads.ts'

type Maps = NonNullable<Project['maps']>

/** A map that has been brought. */
export interface Stage {
  readonly id: string
  readonly map: MapFile
  readonly picture: Picture
  readonly roads: readonly Road[]
}

/** What a map looks like that a project has drawn itself, or that everybody has; null: it is not there. */
async function textOf(id: string, own: Maps): Promise<string | null> {
  const mine = ownMapIn(id)
  if (mine === null) return maps.map(id)
  if (!Object.hasOwn(own, mine)) return null
  // Most projects have none.
  const { writeMap } = await import('@botgarten/maps/own')
  return writeMap(own[mine]!, mine)
}

/** Null where there is no such map, or its file breaks a rule. `own`: the maps of the project. */
export async function loadStage(id: string, own: Maps = {}): Promise<Stage | null> {
  const text = await textOf(id, own)
  if (text === null) return null
  const { map } = readMap(text)
  return map && { id, map, picture: takeApart(text, map), roads: roadsOf(map) }
}

/** A course at its beginning; null where the map has no such station: the block says so. */
export function courseOn({ map }: Stage, outline: LearningOutline, seed: number): Course | null {
  try {
    return courseOf(outline, map, seed)
  } catch (cause) {
    if (!(cause instanceof RangeError)) throw cause
    return null
  }
}
