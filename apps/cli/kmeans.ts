import { readFileSync, statSync } from 'node:fs'
import {
  bestOf,
  cluster,
  LARGEST,
  pointsOf,
  type Clustering,
  type Distance,
  type Points,
} from '@botgarten/learning/k-means'
import { decodeTable, readTable, TableError, type Encoding, type Table } from '@botgarten/materials/tables'
import { stream } from '@botgarten/numbers'
import { CallError, FileError, options, wholeNumberIn } from './errors.ts'
import { oneOf, seedOf } from './learn-options.ts'

const known = {
  data: { type: 'string' },
  k: { type: 'string' },
  init: { type: 'string' },
  distance: { type: 'string' },
  starts: { type: 'string' },
  seed: { type: 'string' },
  'decimal-comma': { type: 'boolean' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

const tooLarge = 200_000_000
const limits = { rows: 1_000_000, columns: 100, largest: LARGEST }
const distances: readonly Distance[] = ['euclidean', 'manhattan', 'cosine']

/** `botgarten learn kmeans`: groups in a table of numbers. */
export function kMeans(args: string[]): string {
  const { values, positionals } = options(args, known)
  if (positionals.length > 0)
    throw new CallError(`"learn kmeans" does not know what to do with "${positionals[0]}".`)
  if (values.data === undefined) throw new CallError('--data is needed: a file of numbers as CSV.')
  if (values.k === undefined) throw new CallError('--k is needed: how many groups to find.')
  const distance = oneOf('distance', values.distance, distances)
  const table = tableIn(values.data, values)
  const points = pointsOf(table.rows)
  const found = find(points, wholeNumberIn('k', values.k, 1, 1, points.count), distance, values)
  const { centres, labels, inertia, iterations } = found
  process.stderr.write(`botgarten: read ${readingOf(table)}.\n`)
  const { columns, rows, reading, encoding } = table
  const read = { columns: columns.length, rows: rows.length, ...reading, encoding }
  if (values.json) return JSON.stringify({ centres, labels, inertia, iterations, read })
  return table.maybeOneColumn ? `${sentenceOf(found)}; ${eitherWay}` : sentenceOf(found)
}

const eitherWay =
  'commas were read as marks between two columns, --decimal-comma reads one column of decimal numbers'

function find(points: Points, groups: number, distance: Distance, values: Values): Clustering {
  const { init = '++' } = values
  const seed = seedOf(values)
  if (init === 'random' || init === '++') {
    const starts = wholeNumberIn('starts', values.starts, 10, 1, 100_000)
    return bestOf(points, groups, { starts, init, distance, stream: stream(seed, 'learn/kmeans/1') })
  }
  if (values.starts !== undefined)
    throw new CallError('--starts goes with --init random or ++; a file of centres is one start.')
  return cluster(points, centresIn(init, groups, points.features, values), distance)
}

function centresIn(
  path: string,
  groups: number,
  features: number,
  values: Values,
): readonly (readonly number[])[] {
  const { rows, columns } = tableIn(path, values)
  if (rows.length !== groups || columns.length !== features)
    throw new FileError(
      `"${path}" has ${rows.length} centres of ${columns.length} numbers; ${groups} of ${features} are needed.`,
    )
  return rows
}

interface ReadTable extends Table {
  readonly encoding: Encoding
}

function tableIn(path: string, values: Values): ReadTable {
  try {
    if (statSync(path).size > tooLarge) throw new Error(`it has more than ${tooLarge} bytes`)
    const { text, encoding } = decodeTable(readFileSync(path))
    const table = readTable(text, limits, { decimalComma: values['decimal-comma'] ?? false })
    return { ...table, encoding }
  } catch (error) {
    const what = error instanceof TableError ? 'is no table of numbers' : 'cannot be read'
    throw new FileError(`"${path}" ${what}: ${(error as Error).message}`)
  }
}

function sentenceOf({ centres, labels, inertia, iterations }: Clustering): string {
  const sizes = centres.map((_, group) => labels.filter((label) => label === group).length)
  return `After ${iterations} rounds: inertia ${inertia.at(-1)}, ${centres.length} groups of ${sizes.join(', ')} points`
}

/** How the file was understood: one column, decimal comma. */
function readingOf({ columns, rows, reading: { mark, decimal, heading }, encoding }: ReadTable): string {
  return [
    mark === null ? 'one column' : `${columns.length} columns with a ${mark} between them`,
    ...(decimal === null ? [] : [`decimal ${decimal}`]),
    ...(heading ? ['a heading'] : []),
    `${rows.length} rows`,
    ...(encoding === 'utf-8' ? [] : [encoding]),
  ].join(', ')
}
