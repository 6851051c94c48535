import type { Row } from './row.ts'

/** One of so many parts of a sweep: machines share the work. */
export interface Shard {
  readonly part: number
  readonly parts: number
}

/** The part's own pieces: the joined parts are the whole, in order. */
export const pieceOf = <Item>(all: readonly Item[], { part, parts }: Shard): Item[] =>
  all.slice(Math.floor(((part - 1) * all.length) / parts), Math.floor((part * all.length) / parts))

const columns = [
  ...(['alpha', 'gamma', 'nu', 'rho', 'alphaDecay', 'rhoDecay', 'runs', 'foundShortest'] as const),
  ...(['shortestAtEnd', 'anyAtEnd', 'medianFirst', 'meanFirst'] as const),
  ...(['learnedAtEnd', 'meanReturn', 'bestReturn'] as const),
]

/** Rows as CSV; the header is in the first part alone. `withMap`: where rows of several maps stand in one table. */
export function csvOf(
  rows: readonly (Row & { readonly map?: string })[],
  { part }: Shard,
  withMap = false,
): string {
  const names = withMap ? (['map', ...columns] as const) : columns
  const lines = rows.map((row) => names.map((column) => row[column] ?? '').join(','))
  return [...(part === 1 ? [names.join(',')] : []), ...lines].map((line) => line + '\n').join('')
}
