import { existsSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { readMap, type MapFile, type MapProblem } from '@botgarten/maps'
import { CallError, FileError } from './errors.ts'
import { readText } from './files.ts'
import { note } from './notes.ts'
import { message } from './words.ts'

/** In megabytes. */
const tooLarge = 4

/** A map of the product by its name, or one from an SVG file. */
export function findMap(what: string): MapFile {
  const shipped = content.map(what)
  if (shipped === null && !existsSync(what))
    throw new CallError('call.noMapNoFile', { name: what, maps: content.maps.join(', ') })
  const { map, problems, warnings } = readMap(shipped ?? readText(what, tooLarge))
  const named = warnings.map(sentenceFor).join('; ')
  if (!map)
    throw new FileError('file.noMap', {
      path: what,
      why: [...problems.map(sentenceFor), named].filter(Boolean).join('; '),
    })
  if (named !== '') note(message('file.mapWith', { path: what, why: named }))
  return map
}

/** What is wrong with a drawing, in the language of this call. */
export const sentenceFor = ({ kind, facts }: MapProblem): string =>
  message(
    `map.${kind}`,
    Object.fromEntries(Object.entries(facts).map(([name, value]) => [name, shorten(value)])),
  )

const shorten = (fact: string | number) =>
  typeof fact === 'string' && fact.length > 40 ? `${fact.slice(0, 40)}…` : fact
