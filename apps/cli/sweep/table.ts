import { CallError } from '../errors.ts'
import { write } from '../files.ts'
import type { Row } from './runs.ts'

/** Options of every sweep: how much of it, and where its table goes. */
export const tableOptions = {
  runs: { type: 'string' },
  threads: { type: 'string' },
  shard: { type: 'string' },
  csv: { type: 'string' },
  json: { type: 'boolean' },
} as const

const columns = [
  ...(['alpha', 'gamma', 'nu', 'rho', 'alphaDecay', 'rhoDecay', 'runs', 'foundShortest'] as const),
  ...(['shortestAtEnd', 'anyAtEnd', 'medianFirst', 'meanFirst'] as const),
  ...(['learnedAtEnd', 'meanReturn', 'bestReturn'] as const),
]

export interface Shard {
  readonly part: number
  readonly parts: number
}

/** `I/N`: the I-th of N parts. */
export function shardIn(text = '1/1'): Shard {
  const [, part, parts] = /^(\d+)\/(\d+)$/.exec(text)?.map(Number) ?? []
  if (part === undefined || parts === undefined || part < 1 || part > parts)
    throw new CallError('call.shard', { text })
  return { part, parts }
}

/** The part's own pieces: the joined parts are the whole, in order. */
export const pieceOf = <Item>(all: readonly Item[], { part, parts }: Shard): Item[] =>
  all.slice(Math.floor(((part - 1) * all.length) / parts), Math.floor((part * all.length) / parts))

/** Progress goes beside the result, and only to somebody who looks. */
export function tell(count: number, of: number): void {
  if (process.stderr.isTTY) process.stderr.write(`\r${count} of ${of}${count === of ? '\n' : ''}`)
}

/** Rows as CSV; the header is in the first part alone. `map`: where rows of several maps stand in one table. */
export function csvOf(
  rows: readonly (Row & { readonly map?: string })[],
  { part }: Shard,
  withMap = false,
): string {
  const names = withMap ? (['map', ...columns] as const) : columns
  const lines = rows.map((row) => names.map((column) => row[column] ?? '').join(','))
  return [...(part === 1 ? [names.join(',')] : []), ...lines].map((line) => line + '\n').join('')
}

/** Where the call names a file the table goes there and a sentence comes back. */
export function handOut(table: string, csv: string | undefined, settings: number): string {
  if (csv === undefined) return table.trimEnd()
  write(csv, table)
  return `${settings} settings: ${csv}`
}
