import Papa from 'papaparse'
import { TableError, type Table } from './types.ts'

/** What a reader of tables may take in. */
export interface TableLimits {
  readonly rows: number
  readonly columns: number
}

/**
 * Reads a table of numbers as CSV: comma, semicolon or tab between cells; decimal point or, where the cells are not parted
 * by commas or stand in quotes, decimal comma. A first row without any number is the heading.
 * @throws TableError that names the place, counted from 1 as a spreadsheet counts
 */
export function readTable(text: string, limits: TableLimits): Table {
  const rows = cellsOf(text, limits)
  if (rows.length === 0) throw new TableError('empty', {})
  const heading = rows.length > 1 && rows[0]!.every((cell) => numberIn(cell) === null) ? rows.shift()! : null
  const width = heading?.length ?? rows[0]!.length
  if (rows.length > limits.rows) throw new TableError('manyRows', { most: limits.rows })
  if (width > limits.columns) throw new TableError('manyColumns', { columns: width, most: limits.columns })
  const above = heading ? 2 : 1
  const columns = Array.from({ length: width }, (_, column) => heading?.[column]?.trim() || `${column + 1}`)
  return { columns, rows: numbersIn(rows, width, above) }
}

function cellsOf(text: string, limits: TableLimits): string[][] {
  if (text.trim() === '') return []
  // One row for the heading, one to see that there are too many.
  const preview = limits.rows + 2
  const { data, meta } = Papa.parse<string[]>(text, {
    delimiter: delimiterOf(text),
    skipEmptyLines: 'greedy',
    preview,
  })
  if (meta.truncated) throw new TableError('manyRows', { most: limits.rows })
  return data
}

/** A spreadsheet that writes decimal commas parts cells by semicolons: where one is, a comma is none. */
function delimiterOf(text: string): string {
  const [start] = text.replace(/"[^"]*"/g, '').split(/\r?\n|\r/, 1)
  return ['\t', ';'].find((mark) => start!.includes(mark)) ?? ','
}

function numbersIn(rows: readonly (readonly string[])[], width: number, above: number): number[][] {
  const commas = rows.some((row) => row.some((cell) => cell.includes(',')))
  return rows.map((cells, index) => {
    const row = index + above
    if (cells.length !== width)
      throw new TableError('unequalRows', { row, cells: cells.length, columns: width })
    return cells.map((cell, column) => {
      const number = numberIn(cell)
      if (number === null) throw new TableError('noNumber', { row, column: column + 1, cell: shorten(cell) })
      if (commas && cell.includes('.'))
        throw new TableError('twoPoints', { row, column: column + 1, cell: shorten(cell) })
      return number
    })
  })
}

const shorten = (cell: string) => (cell.length > 20 ? `${cell.slice(0, 20)}…` : cell)

function numberIn(cell: string): number | null {
  const text = cell.trim()
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(text)) return null
  const number = Number(text.replace(',', '.'))
  return Number.isFinite(number) ? number : null
}
