import type { Draft } from './draft.ts'
import { wrap } from './format.ts'
import type { Line, PythonFile } from './types.ts'

interface Sections {
  readonly functions: readonly (readonly Line[])[]
  readonly made: readonly Line[]
  readonly main: readonly Line[]
}

/** A row of the file and the blocks it belongs to. */
interface Row {
  readonly text: string
  readonly blocks: readonly string[]
}

const plain = (text: string): Row => ({ text, blocks: [] })
const blank = plain('')

const rowsOf = (lines: readonly Line[]): readonly Row[] =>
  lines.flatMap(({ code, depth, blocks }) => wrap(code, depth).map((text) => ({ text, blocks })))

/** Head, imports, constants, devices, functions, program: as a person would order it. */
export function assembled(draft: Draft, { functions, made, main }: Sections): PythonFile {
  const head = [...headRows(draft), ...importRows(draft)]
  const plainParts = [rowsOf(draft.constants), deviceRows(draft), globalsBefore(functions, made)]
  const defs = [...helperRows(draft), ...functions.map(rowsOf)]
  const program = rowsOf(functions.length > 0 ? main : [...made, ...main])
  const before = [
    ...head,
    ...plainParts.filter((part) => part.length > 0).flatMap((part) => [blank, ...part]),
  ]
  const rows = [
    ...before,
    ...defs.flatMap((part) => [blank, blank, ...part]),
    ...(program.length > 0 ? [blank, ...(defs.length > 0 ? [blank] : []), ...program] : []),
  ]
  return {
    text: `${rows.map(({ text }) => text).join('\n')}\n`,
    lines: rows.map(({ blocks }) => blocks),
    head: before.length,
    notes: draft.notes,
  }
}

/** Functions see variables that are made before them. */
const globalsBefore = (functions: Sections['functions'], made: readonly Line[]) =>
  functions.length > 0 ? rowsOf(made) : []

function headRows({ input, devices, say }: Draft): readonly Row[] {
  const name = input.name.replace(/\s+/g, ' ').trim()
  const plugs = [...devices.values()]
    .sort((a, b) => a.order - b.order)
    .flatMap(({ plug }) => (plug === undefined ? [] : plug.split('\n')))
  const dialect = say(`python.dialect.${input.dialect}`)
  return [
    ...(input.dialect === 'ev3dev2' ? [plain('#!/usr/bin/env python3')] : []),
    plain(`# ${say('python.head', { name })}`),
    plain(`# ${dialect}`),
    ...[...new Set(plugs)].sort().map((plug) => plain(`# ${plug}`)),
  ]
}

const byName = ([a]: readonly [string, unknown], [b]: readonly [string, unknown]) => (a < b ? -1 : 1)
const own = (module: string) => (/^(ev3dev2|pybricks|umath|urandom)/.test(module) ? 1 : 0)

/** Python's own modules first, then the robot's. */
function importRows({ imports }: Draft): readonly Row[] {
  const sorted = [...imports].sort(byName)
  const groups = [0, 1].map((group) => sorted.filter(([module]) => own(module) === group))
  const rows = groups.map((group) =>
    group.flatMap(([module, names]) =>
      wrapImport(`from ${module} import `, [...names].sort(byCase)).map(plain),
    ),
  )
  const filled = rows.filter((group) => group.length > 0)
  return filled.flatMap((group, k) => (k === 0 ? group : [blank, ...group]))
}

/** Constants before classes before functions, as isort has them. */
function byCase(a: string, b: string): number {
  const rank = (name: string) =>
    /^[A-Z0-9_]+$/.test(name) && name.length > 1 ? 0 : /^[A-Z]/.test(name) ? 1 : 2
  return rank(a) - rank(b) || (a < b ? -1 : 1)
}

function wrapImport(head: string, names: readonly string[]): readonly string[] {
  const one = head + names.join(', ')
  if (one.length <= 88) return [one]
  return [`${head}(`, ...names.map((name) => `    ${name},`), ')']
}

const deviceRows = ({ devices }: Draft): readonly Row[] =>
  [...devices.values()]
    .sort((a, b) => a.order - b.order)
    .flatMap(({ code, blocks }) => rowsOf(code.map((row) => ({ code: row, depth: 0, blocks: [...blocks] }))))

function helperRows({ helpers }: Draft): readonly (readonly Row[])[] {
  return [...helpers.values()].map(({ rows, blocks }) =>
    rowsOf(
      rows.map((row) => ({
        code: row.trimStart(),
        depth: (row.length - row.trimStart().length) / 4,
        blocks,
      })),
    ),
  )
}
