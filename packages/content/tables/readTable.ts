import Papa from 'papaparse'
import { TableError, type Reading, type Table } from './types.ts'

/** What a reader of tables may take in. */
export interface TableLimits {
  readonly rows: number
  readonly columns: number
  /** The largest number, and with a minus the smallest. */
  readonly largest?: number
}

/** How a table is read that is not as it should be. */
interface Leniency {
  /** Commas never part cells. */
  readonly decimalComma?: boolean
  /** Of too many rows the first ones are taken. */
  readonly first?: boolean
  /** Rows in which something is no number are left out. */
  readonly leaveOut?: boolean
}

/**
 * Reads a table of numbers as CSV: comma, semicolon or tab between cells; decimal point or, where the cells are not parted
 * by commas or stand in quotes, decimal comma. A first row without any number is the heading. Of one column, commas are
 * decimal commas where only that makes a table of it, or where one stands before a zero (1,05): see `commasIn`.
 * @throws TableError that names the place, counted from 1 as a spreadsheet counts
 */
export function readTable(text: string, limits: TableLimits, leniency: Leniency = {}): Table {
  const { decimalComma = false, first = false, leaveOut = false } = leniency
  const commas = decimalComma ? 'decimal' : commasIn(text)
  const mark = commas === 'decimal' ? aloneMark(text) : markIn(text)
  const rows = cellsOf(text, mark, limits, first)
  if (rows.length === 0) throw new TableError('empty', {})
  const heading = rows.length > 1 && rows[0]!.every((cell) => numberIn(cell) === null) ? rows.shift()! : null
  const width = heading?.length ?? rows[0]!.length
  if (rows.length > limits.rows && !first) throw new TableError('manyRows', { most: limits.rows })
  const taken = rows.slice(0, limits.rows)
  if (width > limits.columns) throw new TableError('manyColumns', { columns: width, most: limits.columns })
  const above = heading ? 2 : 1
  const columns = Array.from({ length: width }, (_, column) => heading?.[column]?.trim() || `${column + 1}`)
  const reading: Reading = {
    ...{ mark: width > 1 ? markNames[mark]! : null, decimal: pointIn(taken) },
    heading: heading !== null,
  }
  const shape = { width, above, largest: limits.largest ?? Infinity, commas: reading.decimal === 'comma' }
  const table = { columns, rows: numbersIn(taken, shape, leaveOut), reading }
  return commas === 'either' ? { ...table, maybeOneColumn: true } : table
}

function cellsOf(text: string, delimiter: string, limits: TableLimits, first: boolean): string[][] {
  if (text.trim() === '') return []
  // One row for the heading, one to see that there are too many.
  const preview = limits.rows + 2
  const { data, meta } = Papa.parse<string[]>(text, { delimiter, skipEmptyLines: 'greedy', preview })
  if (meta.truncated && !first) throw new TableError('manyRows', { most: limits.rows })
  return data
}

/** A spreadsheet that writes decimal commas parts cells by semicolons: where one is, a comma is none. */
const markIn = (text: string): string => otherMark(text) ?? ','
const aloneMark = (text: string): string => otherMark(text) ?? ';'

function otherMark(text: string): string | undefined {
  const [start] = text.replace(/"[^"]*"/g, '').split(/\r?\n|\r/, 1)
  return ['\t', ';'].find((mark) => start!.includes(mark))
}

/**
 * What commas are in a file without semicolons and tabs. Decimal, where every row is one number and: the heading has one
 * cell, or only some rows have a comma, or one stands before a zero with more behind it. Where every row has one comma and
 * nothing else tells, they part cells, as the name CSV says, or `either`.
 */
function commasIn(text: string): 'decimal' | 'marks' | 'either' {
  if (otherMark(text) !== undefined) return 'marks'
  const lines = text
    .replace(/^\uFEFF/, '')
    .split(/\r?\n|\r/)
    .map((line) => line.trim())
    .filter((line) => line !== '')
  const heading =
    lines.length > 1 && numberIn(lines[0]!.replaceAll('"', '')) === null && !lines[0]!.includes(',')
  const numbers = heading ? lines.slice(1) : lines
  const withComma = numbers.filter((line) => line.includes(','))
  if (withComma.length === 0 || numbers.some((line) => numberIn(line) === null)) return 'marks'
  if (numbers.some((line) => line.includes('.'))) return 'marks'
  const tells = heading || withComma.length < numbers.length || withComma.some((line) => /,0\d/.test(line))
  return tells ? 'decimal' : 'either'
}

const markNames: { readonly [mark: string]: Reading['mark'] } = {
  ',': 'comma',
  ';': 'semicolon',
  '\t': 'tab',
}

function pointIn(rows: readonly (readonly string[])[]): Reading['decimal'] {
  const has = (point: string) => rows.some((row) => row.some((cell) => cell.includes(point)))
  return has(',') ? 'comma' : has('.') ? 'point' : null
}

interface Shape {
  readonly width: number
  /** Number of the first row, as a spreadsheet counts. */
  readonly above: number
  readonly largest: number
  /** Do commas part the digits, so that a point is a mistake? */
  readonly commas: boolean
}

/** The rows as numbers. @throws TableError for the first row that is wrong, unless such rows are left out and others remain */
function numbersIn(rows: readonly (readonly string[])[], shape: Shape, leaveOut: boolean): number[][] {
  const wrong = rows.map((cells, index) => wrongIn(cells, index + shape.above, shape))
  const bad = wrong.filter((one) => one !== null)
  const someAreGood = bad.length < rows.length
  if (bad[0] && !(leaveOut && someAreGood))
    throw new TableError(bad[0].problem, bad[0].facts, someAreGood ? bad.length : 0)
  return rows.filter((_, index) => wrong[index] === null).map((cells) => cells.map((cell) => numberIn(cell)!))
}

type Wrong = Pick<TableError, 'problem' | 'facts'>

/** The first mistake in a row; null: there is none. */
function wrongIn(cells: readonly string[], row: number, { width, largest, commas }: Shape): Wrong | null {
  if (cells.length !== width)
    return { problem: 'unequalRows', facts: { row, cells: cells.length, columns: width } }
  for (const [column, cell] of cells.entries()) {
    const facts = { row, column: column + 1, cell: shorten(cell) }
    const number = numberIn(cell)
    if (number === null) return { problem: 'noNumber', facts }
    if (commas && cell.includes('.')) return { problem: 'twoPoints', facts }
    if (Math.abs(number) > largest) return { problem: 'tooBig', facts: { ...facts, most: largest } }
  }
  return null
}

const shorten = (cell: string) => (cell.length > 20 ? `${cell.slice(0, 20)}…` : cell)

function numberIn(cell: string): number | null {
  const text = cell.trim()
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(text)) return null
  const number = Number(text.replace(',', '.'))
  return Number.isFinite(number) ? number : null
}
