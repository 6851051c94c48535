import { existsSync, readdirSync } from 'node:fs'
import { join } from 'node:path'
import { readMap, type MapFile, type MapProblem } from '@botgarten/maps'
import { CallError, FileError } from './errors.ts'
import { readText } from './files.ts'
import { note } from './notes.ts'
import { say } from './words.ts'

const folder = join(import.meta.dirname, '../../content/maps')
/** In megabytes. */
const tooLarge = 4

/** Names of the maps of the product. */
export const shippedMaps = (): readonly string[] => readdirSync(folder)

/** A map of the product by its name, or one from an SVG file. */
export function findMap(what: string): MapFile {
  const shipped = shippedMaps()
  if (!shipped.includes(what) && !existsSync(what))
    throw new CallError('call.noMapNoFile', { name: what, maps: shipped.join(', ') })
  const path = shipped.includes(what) ? join(folder, what, 'map.svg') : what
  const { map, problems, warnings } = readMap(readText(path, tooLarge))
  const named = warnings.map(sentenceFor).join('; ')
  if (!map)
    throw new FileError('file.noMap', {
      path: what,
      why: [...problems.map(sentenceFor), named].filter(Boolean).join('; '),
    })
  if (named !== '') note(say('file.mapWith', { path: what, why: named }))
  return map
}

const sentenceFor = ({ kind, facts }: MapProblem): string =>
  say(`map.${kind}`, Object.fromEntries(Object.entries(facts).map(([name, value]) => [name, shorten(value)])))

const shorten = (fact: string | number) =>
  typeof fact === 'string' && fact.length > 40 ? `${fact.slice(0, 40)}…` : fact
