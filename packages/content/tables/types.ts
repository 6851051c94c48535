export type Encoding = 'utf-8' | 'utf-16le' | 'utf-16be' | 'windows-1252'

/** How a file was understood. */
export interface Reading {
  /** What parts the cells; null in one column. */
  readonly mark: 'comma' | 'semicolon' | 'tab' | null
  /** Null where all numbers are whole. */
  readonly decimal: 'comma' | 'point' | null
  /** The first row names the columns. */
  readonly heading: boolean
}

/** A table of numbers, from a file. */
export interface Table {
  /** As the heading says, or their number from 1. */
  readonly columns: readonly string[]
  readonly rows: readonly (readonly number[])[]
  readonly reading: Reading
  /** The commas may as well be decimal commas of one column: nothing in the file tells. */
  readonly maybeOneColumn?: true
}

export type TableProblem =
  'empty' | 'manyRows' | 'manyColumns' | 'unequalRows' | 'noNumber' | 'twoPoints' | 'tooBig' | 'spreadsheet'

/** A file that is no table of numbers. `problem` and `facts` say it to who has words. */
export class TableError extends Error {
  readonly problem: TableProblem
  readonly facts: { readonly [name: string]: string | number }
  /** So many rows would have to be left out, and others would remain; 0: that does not help. */
  readonly badRows: number

  constructor(problem: TableProblem, facts: TableError['facts'], badRows = 0) {
    super(`${problem} ${JSON.stringify(facts)}`)
    this.problem = problem
    this.facts = facts
    this.badRows = badRows
  }
}
