/**
 * A learned number with all that makes it again: `data` holds numbers and the names of a method's parts, never a text that
 * somebody typed, and `learn` and `show` are Python that needs NumPy alone. What learns by trying anywhere is a `q`.
 */
export interface Proof {
  readonly method: 'net' | 'q' | 'k-means'
  /** As the screen or the command line says it, not rounded. The last line that `show` prints. */
  readonly number: number
  readonly data: { readonly [name: string]: unknown }
  /** Rounds or steps before the data begin: what a file would be too large for. */
  readonly before: number
  /** From the data to what is learned. */
  readonly learn: string
  /** From that to the number. */
  readonly show: string
}

/** Parts of a notebook that have a text of their own before them. */
export type Part = 'title' | 'data' | 'learn' | 'number'

/** Numbers of a file: draws and points beyond that are left out, or the file is refused. About 4 MB. */
export const mostNumbers = 200_000
