import type { Mirror } from '../../train/rows.ts'
import type { ShownPair } from '../rows.ts'

/** A table as the checks look at it: the examples that practise, in percent. */
export interface Table {
  readonly pairs: readonly ShownPair[]
  /** Ids of the columns. */
  readonly inputs: readonly string[]
  readonly outputs: readonly string[]
  /** Which outputs are the wheels; null: they are not among them. */
  readonly wheels: { readonly left: number; readonly right: number } | null
  /** Does practice add the mirror images? */
  readonly mirror: Mirror | null
  /** How many knobs there are: links, and biases that may move. */
  readonly knobs: number
  /** By example: its loss after practice; not given: nothing has been practised. */
  readonly errors?: readonly number[]
  /** What was read where the last drive failed, in percent. */
  readonly failed?: readonly (readonly number[])[]
}

/**
 * A question to the child about its examples: nothing is deleted by it. Rows are places in the whole table. The kinds, the gravest
 * first: checks.ts.
 */
export type ExampleFinding =
  /** Much the same was read as in `others`, and something quite different was wished. */
  | { readonly kind: 'contradiction' | 'blind'; readonly row: number; readonly others: readonly number[] }
  | { readonly kind: 'oddOne'; readonly row: number }
  | { readonly kind: 'oneSided'; readonly left: number; readonly right: number }
  | { readonly kind: 'neverSeen'; readonly readings: readonly number[] }
  /** A column that is always about `value`. */
  | { readonly kind: 'allAlike'; readonly column: string; readonly isInput: boolean; readonly value: number }
  | { readonly kind: 'sleeping'; readonly rows: readonly number[] }
  /** `isMirrored`: the mirror image of each row is practised, too. */
  | { readonly kind: 'few'; readonly rows: number; readonly isMirrored: boolean; readonly knobs: number }

/** The largest difference of any column, in percent. */
export function farApart(a: readonly number[], b: readonly number[]): number {
  let most = 0
  for (let k = 0; k < a.length; k++) {
    const off = Math.abs(a[k]! - b[k]!)
    if (off > most) most = off
  }
  return most
}
