import {
  bestOf,
  cluster,
  LARGEST,
  pointsOf,
  type Clustering,
  type Distance,
  type Points,
} from '@botgarten/learning/k-means'
import { kMeansProof } from '@botgarten/learning/proof'
import { decodeTable, readTable, TableError, type Encoding, type Table } from '@botgarten/content/tables'
import { stream } from '@botgarten/numbers'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { readBytes } from './files.ts'
import { seedOf } from './learn-options.ts'
import { writeNotebook } from './notebook.ts'
import { note } from './notes.ts'
import { oneOf, options, refuseMore, wholeNumberIn } from './options.ts'
import { message } from './words.ts'

const known = {
  data: { type: 'string' },
  k: { type: 'string' },
  init: { type: 'string' },
  distance: { type: 'string' },
  starts: { type: 'string' },
  seed: { type: 'string' },
  'decimal-comma': { type: 'boolean' },
  notebook: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

/** In megabytes. */
const tooLarge = 200
const limits = { rows: 1_000_000, columns: 100, largest: LARGEST }
const distances: readonly Distance[] = ['euclidean', 'manhattan', 'cosine']

/** `botgarten learn kmeans`: groups in a table of numbers. */
export const kMeans: Command = { options: known, execute: findGroups }

function findGroups(args: string[]): string {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  if (values.data === undefined) throw new CallError('call.needsData')
  if (values.k === undefined) throw new CallError('call.needsK')
  const distance = oneOf('distance', values.distance, distances)
  const table = tableIn(values.data, values)
  const points = pointsOf(table.rows)
  const found = find(points, wholeNumberIn('k', values.k, 1, 1, points.count), distance, values)
  const { centres, labels, inertia, iterations, start } = found
  if (values.notebook !== undefined)
    writeNotebook(values.notebook, kMeansProof({ points, centres: start, distance, rounds: inertia.length }))
  note(message('groups.read', { how: readingOf(table) }))
  const { columns, rows, reading, encoding } = table
  const read = { columns: columns.length, rows: rows.length, ...reading, encoding }
  if (values.json) return JSON.stringify({ centres, labels, inertia, iterations, read })
  const sentence = sentenceOf(found)
  return table.maybeOneColumn ? message('groups.foundEitherWay', { found: sentence }) : sentence
}

interface Found extends Clustering {
  readonly start: readonly (readonly number[])[]
}

function find(points: Points, groups: number, distance: Distance, values: Values): Found {
  const { init = '++' } = values
  const seed = seedOf(values)
  if (init === 'random' || init === '++') {
    const starts = wholeNumberIn('starts', values.starts, 10, 1, 100_000)
    return bestOf(points, groups, { starts, init, distance, stream: stream(seed, 'learn/kmeans/1') })
  }
  if (values.starts !== undefined) throw new CallError('call.startsOfOwn')
  const start = centresIn(init, groups, points.features, values)
  return { ...cluster(points, start, distance), start }
}

function centresIn(
  path: string,
  groups: number,
  features: number,
  values: Values,
): readonly (readonly number[])[] {
  const { rows, columns } = tableIn(path, values)
  if (rows.length !== groups || columns.length !== features)
    throw new FileError('file.centres', {
      ...{ path, centres: rows.length, numbers: columns.length },
      ...{ groups, features },
    })
  return rows
}

interface ReadTable extends Table {
  readonly encoding: Encoding
}

function tableIn(path: string, values: Values): ReadTable {
  const bytes = readBytes(path, tooLarge)
  try {
    const { text, encoding } = decodeTable(bytes)
    const table = readTable(text, limits, { decimalComma: values['decimal-comma'] ?? false })
    return { ...table, encoding }
  } catch (error) {
    if (!(error instanceof TableError)) throw error
    throw new FileError('file.noTable', { path, why: message(`table.${error.problem}`, error.facts) })
  }
}

function sentenceOf({ centres, labels, inertia, iterations }: Clustering): string {
  const sizes = centres.map((_, group) => labels.filter((label) => label === group).length)
  return message('groups.found', {
    ...{ iterations, inertia: inertia.at(-1)!, groups: centres.length },
    sizes: sizes.join(', '),
  })
}

/** How the file was understood: one column, decimal comma. */
function readingOf({ columns, rows, reading: { mark, decimal, heading }, encoding }: ReadTable): string {
  return [
    mark === null
      ? message('groups.oneColumn')
      : message('groups.columns', { count: columns.length, mark: message(`groups.${mark}`) }),
    ...(decimal === null ? [] : [message('groups.decimal', { mark: message(`groups.${decimal}`) })]),
    ...(heading ? [message('groups.heading')] : []),
    message('groups.rows', { count: rows.length }),
    ...(encoding === 'utf-8' ? [] : [encoding]),
  ].join(', ')
}
