/** A table of figures: what was measured, in words of a person, and under which conditions. */
export interface Table {
  readonly title: string
  /** One or two sentences: what is run, and how it is timed. */
  readonly how: string
  readonly columns: readonly string[]
  readonly rows: readonly (readonly (string | number)[])[]
  /** What a reader has to know to judge the figures. */
  readonly notes?: readonly string[]
}

/** What a file `*.bench.ts` exports as `default`. */
export type Bench = () => Table | Promise<Table>

/** Middle value; of an even number the lower of the two. */
export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b)
  return sorted[Math.floor((sorted.length - 1) / 2)] ?? NaN
}

/** Milliseconds, as tables show them. */
export const ms = (value: number) => `${value.toFixed(1)} ms`

/** The value that `share` of all values do not exceed (nearest rank). `share` 0..1. */
export function percentile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b)
  return sorted[Math.max(0, Math.ceil(sorted.length * share) - 1)] ?? NaN
}
