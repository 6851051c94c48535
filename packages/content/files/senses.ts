import type { LoadedSenseCage } from '../catalogue.ts'
import { readCageRows, readSenseCage } from '../schema/senseCage.ts'
import { readSenseCageText } from '../schema/senseCageText.ts'
import { idOf, named, once, type Folder } from './folder.ts'

/** Cages in which a robot learns with its own sensors, each with what was measured of it. */
export function sensesIn(content: Folder) {
  const folders = once(() => content.foldersWith('senses/*/cage.json'))
  const cageIn = (folder: string): LoadedSenseCage => ({
    cage: named(folder, readSenseCage(content.json(folder, 'cage.json'))),
    rows: readCageRows(content.json(folder, 'rows.json')),
    text: content.translated(folder, readSenseCageText),
  })
  return {
    cages: once(() => folders().map(cageIn)),
    ids: once(() => folders().map(idOf)),
    /** A cage without its rows: with it they are made. */
    cage: (id: string) => {
      const folder = folders().find((one) => idOf(one) === id)
      return folder === undefined ? null : named(folder, readSenseCage(content.json(folder, 'cage.json')))
    },
    /** Path of the picture of the animal. */
    pictureOf: (id: string) =>
      content.path(
        folders().find((folder) => idOf(folder) === id)!,
        'picture.svg',
      ),
  }
}
