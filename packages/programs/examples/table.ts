import {
  headOfRow,
  mostOf,
  place,
  type Drive,
  type Examples,
  type Row,
} from '@botgarten/learning/neural-network/examples'
import { ExamplesError } from './error.ts'

// Examples as a table: a column a neuron, named by its id, then `drive` (a number) and `on` (1, or 0 for set aside).

const extra = ['drive', 'on'] as const

interface Numbers {
  readonly columns: readonly string[]
  readonly rows: readonly (readonly number[])[]
}

/**
 * Examples from a table of numbers with a heading, its columns in any order. Wishes are cut to ±100; `outside`: how many
 * numbers lay outside of 0..100 for inputs and of ±100 for wishes. Each row without `drive` is a drive of its own up to the
 * limit of drives, then all are one. `first`: of too many rows or drives the first ones are taken.
 * @throws {ExamplesError} and nothing else
 */
export function examplesFromTable(
  { columns, rows: all }: Numbers,
  inputs: readonly string[],
  outputs: readonly string[],
  first = false,
): { readonly examples: Examples; readonly outside: number } {
  if (all.length > mostOf.rows && !first) throw new ExamplesError('manyRows', { most: mostOf.rows })
  const at = placesOf(columns, [...inputs, ...outputs])
  const column = columns.indexOf('drive')
  const rows = first ? firstRows(all, column) : all
  const driveOf = drivesIn(rows, column)
  const isOn = columns.indexOf('on')
  let outside = 0
  const table = rows.map((values, index): Row => {
    const read = inputs.map((id) => values[at.get(id)!]!)
    const wished = outputs.map((id) => values[at.get(id)!]!)
    outside += read.filter((value) => value < 0 || value > 100).length
    outside += wished.filter((value) => Math.abs(value) > 100).length
    const on = isOn >= 0 && values[isOn] === 0 ? 0 : 1
    return [driveOf.drive(index), 0, 0, 0, 0, on, ...read, ...wished.map(cut)]
  })
  return { examples: { version: 1, inputs, outputs, drives: driveOf.drives, rows: table }, outside }
}

const cut = (value: number) => Math.max(-100, Math.min(100, value))

function placesOf(columns: readonly string[], ids: readonly string[]): ReadonlyMap<string, number> {
  if (columns.every((name, index) => name === `${index + 1}`))
    throw new ExamplesError('noHeading', { known: ids.join(', ') })
  const known: readonly string[] = [...ids, ...extra]
  const twice = columns.find((name, index) => columns.indexOf(name) !== index)
  if (twice !== undefined) throw new ExamplesError('twiceColumn', { column: twice })
  const unknown = columns.find((name) => !known.includes(name))
  if (unknown !== undefined)
    throw new ExamplesError('unknownColumn', { column: unknown, known: known.join(', ') })
  const missing = ids.find((id) => !columns.includes(id))
  if (missing !== undefined) throw new ExamplesError('missingColumn', { column: missing })
  return new Map(ids.map((id) => [id, columns.indexOf(id)]))
}

/** As many rows of as many drives as there may be. */
function firstRows(rows: Numbers['rows'], column: number): Numbers['rows'] {
  if (column < 0) return rows.slice(0, mostOf.rows)
  const drives = new Set([...new Set(rows.map((row) => row[column]))].slice(0, mostOf.drives))
  return rows.filter((row) => drives.has(row[column])).slice(0, mostOf.rows)
}

function drivesIn(rows: readonly (readonly number[])[], column: number) {
  const nameOf = (index: number) =>
    column >= 0 ? String(rows[index]![column]) : rows.length <= mostOf.drives ? String(index + 1) : '1'
  const names = [...new Set(rows.map((_, index) => nameOf(index)))]
  if (names.length > mostOf.drives) throw new ExamplesError('manyDrives', { most: mostOf.drives })
  const drives = names.map((name): Drive => ({ id: `file ${name}`, by: 'file', seed: 0 }))
  const places = new Map(names.map((name, index) => [name, index]))
  return { drives, drive: (index: number) => places.get(nameOf(index))! }
}

/** Examples as CSV with points and commas: those that are on, or with `all` those that are set aside too. Gaps are left out. */
export function examplesCsv({ inputs, outputs, rows }: Examples, all = false): string {
  const heading = [...inputs, ...outputs, ...extra].map(quoted).join(',')
  const lines = rows
    .filter((row) => (all || row[place.on] === 1) && !row.includes(null))
    .map((row) => [...row.slice(headOfRow), row[place.drive]! + 1, row[place.on]].join(','))
  return `${[heading, ...lines].join('\r\n')}\r\n`
}

const quoted = (name: string) => (/[",;\t\r\n]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name)
