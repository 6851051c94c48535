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

/** A file that is no table of numbers. `problem` and `facts` say it to whoever has words; `message` says it in English. */
export class TableError extends Error {
  readonly problem: TableProblem
  readonly facts: { readonly [name: string]: string | number }

  constructor(problem: TableProblem, facts: TableError['facts']) {
    super(sentences[problem].replace(/\{(\w+)\}/g, (_, name: string) => String(facts[name])))
    this.problem = problem
    this.facts = facts
  }
}

const sentences: { readonly [problem in TableProblem]: string } = {
  empty: 'There are no numbers in it.',
  manyRows: 'It has more than {most} rows.',
  manyColumns: 'It has {columns} columns; {most} are the most.',
  unequalRows: 'Row {row} has {cells} cells, the others have {columns}.',
  noNumber: 'Row {row}, column {column}: "{cell}" is not a number.',
  twoPoints: 'Row {row}, column {column}: "{cell}" has a point where other numbers have a comma.',
  tooBig: 'Row {row}, column {column}: "{cell}" is too big to be compared; {most} is the most.',
  spreadsheet: 'It is a file of a spreadsheet: save it there as CSV.',
}
