/** A table of numbers, from a file. */
export interface Table {
  /** As the heading says, or their number from 1. */
  readonly columns: readonly string[]
  readonly rows: readonly (readonly number[])[]
  /** The commas may as well be decimal commas of one column: nothing in the file tells. */
  readonly maybeOneColumn?: true
}

export type TableProblem = 'empty' | 'manyRows' | 'manyColumns' | 'unequalRows' | 'noNumber' | 'twoPoints'

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
}
