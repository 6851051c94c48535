import maps from 'content:maps'
import type { Course } from '@botgarten/learning/q-learning'
import { courseOf, readMap, type MapFile } from '@botgarten/maps'
import type { LearningOutline } from '@botgarten/programs'
import { takeApart, type Picture } from './picture.ts'
import { roadsOf, type Road } from './roads.ts'

/** A map that has been brought. */
export interface Stage {
  readonly id: string
  readonly map: MapFile
  readonly picture: Picture
  readonly roads: readonly Road[]
}

/** Null where there is no such map, or its file breaks a rule. */
export async function loadStage(id: string): Promise<Stage | null> {
  const text = await maps.map(id)
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
