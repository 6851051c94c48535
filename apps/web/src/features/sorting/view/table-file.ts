import { LARGEST } from '@botgarten/learning/k-means'
import type { Encoding, Table, TableError } from '@botgarten/content/tables'
import { m } from '#words/message.ts'
import { MOST_COLUMNS, MOST_POINTS } from '../model/work.ts'

const limits = { rows: MOST_POINTS, columns: MOST_COLUMNS, largest: LARGEST }
const MOST_MEGABYTES = 5

/** A file of numbers; null where it is none. */
export interface OpenedTable {
  readonly table: Table | null
  /** How it was read, or what is wrong with it. */
  readonly sentence: string
}

/** @param decimalComma of a file whose commas may be either: they are in the numbers */
export async function openTable(file: File, decimalComma = false): Promise<OpenedTable> {
  if (file.size > MOST_MEGABYTES * 1_000_000)
    return { table: null, sentence: m['sorting.table.tooLarge']({ most: MOST_MEGABYTES }) }
  const { decodeTable, readTable, TableError } = await import('@botgarten/content/tables')
  try {
    const { text, encoding } = decodeTable(new Uint8Array(await file.arrayBuffer()))
    const table = readTable(text, limits, { decimalComma })
    return { table, sentence: readingOf(table, encoding) }
  } catch (error) {
    if (error instanceof TableError) return { table: null, sentence: problemOf(error) }
    // A file that has gone or may not be read.
    if (error instanceof DOMException) return { table: null, sentence: m['sorting.table.unread']() }
    throw error
  }
}

type Facts = TableError['facts']
const problems: { readonly [problem in TableError['problem']]: (facts: Facts) => string } = {
  empty: () => m['sorting.table.empty'](),
  manyRows: ({ most }) => m['sorting.table.manyRows']({ most: most! }),
  manyColumns: ({ columns, most }) => m['sorting.table.manyColumns']({ columns: columns!, most: most! }),
  unequalRows: ({ row, cells, columns }) =>
    m['sorting.table.unequalRows']({ row: row!, cells: cells!, columns: columns! }),
  noNumber: ({ row, column, cell }) =>
    m['sorting.table.noNumber']({ row: row!, column: column!, cell: cell! }),
  twoPoints: ({ row, column, cell }) =>
    m['sorting.table.twoPoints']({ row: row!, column: column!, cell: cell! }),
  tooBig: ({ row, column, cell }) => m['sorting.table.tooBig']({ row: row!, column: column!, cell: cell! }),
  spreadsheet: () => m['sorting.table.spreadsheet'](),
}

const problemOf = ({ problem, facts }: TableError): string => problems[problem](facts)

/** "Read: one column, 4 rows, decimal comma." */
function readingOf({ columns, rows, reading }: Table, encoding: Encoding): string {
  const lines = m['sorting.table.read.rows']({ count: rows.length })
  const facts = { columns: columns.length, rows: lines }
  const cells = {
    comma: () => m['sorting.table.read.comma'](facts),
    semicolon: () => m['sorting.table.read.semicolon'](facts),
    tab: () => m['sorting.table.read.tab'](facts),
  }
  const parts = [
    reading.mark === null ? m['sorting.table.read.oneColumn'](facts) : cells[reading.mark](),
    reading.decimal === 'comma' && m['sorting.table.read.decimalComma'](),
    reading.decimal === 'point' && m['sorting.table.read.decimalPoint'](),
    reading.heading && m['sorting.table.read.heading'](),
    encoding.startsWith('utf-16') && m['sorting.table.read.utf16'](),
    encoding === 'windows-1252' && m['sorting.table.read.windows'](),
  ]
  return `${parts.filter(Boolean).join(', ')}.`
}
