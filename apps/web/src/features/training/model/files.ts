import { mostOf, type Examples } from '@botgarten/learning/neural-network/examples'
import type { NetworkOutline } from '@botgarten/programs'
import type { Facts } from '@botgarten/blocks'

/** A table whose columns have to be put to neurons by hand. */
export interface LooseTable {
  readonly columns: readonly string[]
  readonly rows: readonly (readonly number[])[]
}

/** What helps with a file that is refused: its first rows are taken, or the bad ones are left out. */
export type Help = 'first' | 'leaveOut'
export type Helps = { readonly [help in Help]?: boolean }

/** What a file holds; `outside`: numbers beyond what sensors read and wheels can do. */
export type Read =
  | { readonly kind: 'examples'; readonly examples: Examples; readonly outside: number }
  | { readonly kind: 'columns'; readonly table: LooseTable }
  | Refused

export interface Refused {
  readonly kind: 'refused'
  readonly problem: string
  readonly facts: Facts
  /** `count`: so many rows are taken, or left out. */
  readonly offer?: { readonly help: Help; readonly count: number }
}

const mostMegabytes = 5
const mostBytes = mostMegabytes * 1_000_000
const refused = (problem: string, facts: Facts = {}): Refused => ({ kind: 'refused', problem, facts })
const firstRows = { help: 'first', count: mostOf.rows } as const

/** Reads examples from a file, of which nothing is trusted. */
export async function readExamples(file: File, net: NetworkOutline, helps: Helps = {}): Promise<Read> {
  const isJson = /\.json$/i.test(file.name)
  if (file.size > mostBytes && (isJson || !helps.first)) {
    const tooBig = refused('tooBig', { most: mostMegabytes })
    return isJson ? tooBig : { ...tooBig, offer: firstRows }
  }
  try {
    const bytes = new Uint8Array(await file.slice(0, mostBytes).arrayBuffer())
    return isJson ? await fromJson(bytes, net, helps) : await fromTable(bytes, net, helps)
  } catch (error) {
    if (error instanceof DOMException) return refused('unread')
    throw error
  }
}

async function fromJson(bytes: Uint8Array, net: NetworkOutline, helps: Helps): Promise<Read> {
  const { ExamplesError, fitExamples, parseExamplesFile } = await import('@botgarten/programs/examples')
  try {
    const file = parseExamplesFile(new TextDecoder().decode(bytes), helps.first)
    return { kind: 'examples', examples: fitExamples(file, net), outside: 0 }
  } catch (error) {
    if (error instanceof ExamplesError) return withOffer(error)
    throw error
  }
}

/** Too many rows or drives: the first ones may be taken. */
function withOffer({ problem, facts }: { readonly problem: string; readonly facts: Facts }): Refused {
  const isMany = problem === 'manyRows' || problem === 'manyDrives'
  return isMany ? { ...refused(problem, facts), offer: firstRows } : refused(problem, facts)
}

const byHand: readonly string[] = ['noHeading', 'unknownColumn', 'missingColumn', 'twiceColumn']

async function fromTable(bytes: Uint8Array, net: NetworkOutline, helps: Helps): Promise<Read> {
  const { decodeTable, readTable, TableError } = await import('@botgarten/content/tables')
  const limits = { rows: mostOf.rows, columns: 1000, largest: 1e9 }
  try {
    const { text } = decodeTable(bytes)
    const { columns, rows } = readTable(wholeLines(text, bytes.length), limits, helps)
    return await inColumns({ columns, rows }, net, helps)
  } catch (error) {
    if (!(error instanceof TableError)) throw error
    const found = refused(`table.${error.problem}`, error.facts)
    if (error.problem === 'manyRows') return { ...found, offer: firstRows }
    return error.badRows > 0 ? { ...found, offer: { help: 'leaveOut', count: error.badRows } } : found
  }
}

/** Without the line in which a large file was cut. */
const wholeLines = (text: string, bytes: number): string =>
  bytes < mostBytes ? text : text.slice(0, text.lastIndexOf('\n') + 1)

/** Examples of a table whose columns are named by neurons; else its columns have to be put to them. */
export async function inColumns(table: LooseTable, net: NetworkOutline, helps: Helps = {}): Promise<Read> {
  const { ExamplesError, examplesFromTable } = await import('@botgarten/programs/examples')
  const ids = (all: NetworkOutline['inputs']) => all.map(({ id }) => id)
  try {
    const read = examplesFromTable(table, ids(net.inputs), ids(net.outputs), helps.first)
    return { kind: 'examples', ...read }
  } catch (error) {
    if (!(error instanceof ExamplesError)) throw error
    return byHand.includes(error.problem) ? { kind: 'columns', table } : withOffer(error)
  }
}

/** The table with the columns that were chosen for these neurons, under their names; what nobody wants is left out. */
export function chosenColumns(
  { rows }: LooseTable,
  chosen: readonly (readonly [neuron: string, column: number])[],
): LooseTable {
  return {
    columns: chosen.map(([neuron]) => neuron),
    rows: rows.map((row) => chosen.map(([, column]) => row[column]!)),
  }
}
