import { drivesRoad, roadsToTry } from '@botgarten/experiments/roads'
import { readMap } from '@botgarten/maps'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { readText } from './files.ts'
import { findMap, sentenceFor } from './maps.ts'
import { options } from './options.ts'
import { message } from './words.ts'

const known = { json: { type: 'boolean' } } as const

function callOf(args: string[]) {
  const { values, positionals } = options(args, known)
  const [what, ...more] = positionals
  if (what === undefined || more.length > 0) throw new CallError('call.mapWhat')
  return { what, json: values.json === true }
}

/** In megabytes. */
const tooLarge = 4

/** `botgarten map check FILE.svg`: every rule that a drawing breaks. */
export const mapCheck: Command = {
  options: known,
  execute(args) {
    const { what, json } = callOf(args)
    const { map, problems, warnings } = readMap(readText(what, tooLarge))
    const report = {
      ...{
        ok: map !== null,
        stations: map?.stations.length ?? 0,
        roads: map?.map.actions.flat().length ?? 0,
      },
      problems: problems.map((problem) => ({ ...problem, says: sentenceFor(problem) })),
      warnings: warnings.map((problem) => ({ ...problem, says: sentenceFor(problem) })),
    }
    if (json) return JSON.stringify(report)
    const lines = [...report.problems, ...report.warnings].map(({ says }) => `  ${says}`)
    if (map === null) throw new FileError('file.noMap', { path: what, why: lines.join('\n').trim() })
    return [message('map.sound', { stations: report.stations, roads: report.roads }), ...lines].join('\n')
  },
}

/** `botgarten map drive MAP|FILE.svg`: every road in both directions, by simulation. */
export const mapDrive: Command = {
  options: known,
  execute(args) {
    const { what, json } = callOf(args)
    const map = findMap(what)
    const roads = roadsToTry(map).map((road) => ({ road: road.join('-'), driven: drivesRoad(map, road) }))
    const driven = roads.filter((one) => one.driven).length
    if (json) return JSON.stringify({ driven, of: roads.length, roads })
    const lost = roads
      .filter((one) => !one.driven)
      .map(({ road }) => `  ${message('map.notDriven', { road })}`)
    return [message('map.driven', { driven, count: roads.length }), ...lost].join('\n')
  },
}
