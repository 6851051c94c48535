import { ownMapIn } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import { writeMap } from './own/write.ts'
import { readMap } from './readMap.ts'
import type { MapFile } from './types.ts'

/**
 * Maps by the name that a program has for them: those of the project, `own:<id>`, and those that everybody has.
 * @param shipped the others, by their folder
 */
export function mapLookup(
  { maps = {} }: Pick<Project, 'maps'>,
  shipped: (id: string) => MapFile | null,
): (map: string) => MapFile | null {
  return (map) => {
    const id = ownMapIn(map)
    if (id === null) return shipped(map)
    return Object.hasOwn(maps, id) ? readMap(writeMap(maps[id]!, id)).map : null
  }
}
