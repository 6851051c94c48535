import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { readMap, type MapFile } from '@botgarten/materials/maps'
import { CallError, FileError } from './errors.ts'
import { sentenceFor } from './map-problems.ts'

const folder = join(import.meta.dirname, '../../content/maps')
const tooLarge = 4_000_000

/** Names of the maps of the product. */
export const shippedMaps = (): readonly string[] => readdirSync(folder)

/** A map of the product by its name, or one from an SVG file. */
export function findMap(what: string): MapFile {
  const shipped = shippedMaps()
  if (!shipped.includes(what) && !existsSync(what))
    throw new CallError(`There is no map and no file called "${what}". Maps: ${shipped.join(', ')}.`)
  const path = shipped.includes(what) ? join(folder, what, 'map.svg') : what
  const { map, problems, warnings } = readMap(textOf(path))
  const named = warnings.map(sentenceFor).join('; ')
  if (!map)
    throw new FileError(
      `"${what}" is not a map: ${[...problems.map(sentenceFor), named].filter(Boolean).join('; ')}.`,
    )
  if (named !== '') process.stderr.write(`botgarten: in "${what}" ${named}.\n`)
  return map
}

function textOf(path: string): string {
  try {
    if (statSync(path).size > tooLarge) throw new Error(`it has more than ${tooLarge} bytes`)
    return readFileSync(path, 'utf8')
  } catch (error) {
    throw new FileError(`"${path}" cannot be read: ${(error as Error).message}`)
  }
}
