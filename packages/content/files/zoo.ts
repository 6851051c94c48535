import type { LoadedCage } from '../catalogue.ts'
import { readCage } from '../schema/cage.ts'
import { readCageText } from '../schema/cageText.ts'
import { idOf, named, once, type Folder } from './folder.ts'

/** Cages with rewards that cheat, each with a map of its own. */
export function zooIn(content: Folder) {
  const folders = once(() => content.foldersWith('zoo/*/cage.json'))
  const cageIn = (folder: string): LoadedCage => ({
    cage: named(folder, readCage(content.json(folder, 'cage.json'))),
    text: content.translated(folder, readCageText),
  })
  return {
    cages: once(() => folders().map(cageIn)),
    /** Path of the drawing of a cage's map. */
    mapOf: (id: string) =>
      content.path(
        folders().find((folder) => idOf(folder) === id)!,
        'map.svg',
      ),
  }
}
