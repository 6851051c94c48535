import { mostOf, type Examples } from '@botgarten/learning/neural-network/examples'
import type { NetworkOutline } from '@botgarten/programs'
import type { Facts } from '@botgarten/blocks'

/** A table whose columns have to be put to neurons by hand. */
export interface LooseTable {
  readonly columns: readonly string[]
  readonly rows: readonly (readonly number[])[]
}

/** What a file holds; `outside`: numbers beyond what sensors read and wheels can do. */
export type Read =
  | { readonly kind: 'examples'; readonly examples: Examples; readonly outside: number }
  | { readonly kind: 'columns'; readonly table: LooseTable }
  | { readonly kind: 'refused'; readonly problem: string; readonly facts: Facts }

const mostMegabytes = 5
const refused = (problem: string, facts: Facts = {}): Read => ({ kind: 'refused', problem, facts })

/** Reads examples from a file, of which nothing is trusted. */
export async function readExamples(file: File, net: NetworkOutline): Promise<Read> {
  if (file.size > mostMegabytes * 1_000_000) return refused('tooBig', { most: mostMegabytes })
  try {
    const bytes = new Uint8Array(await file.arrayBuffer())
    return /\.json$/i.test(file.name) ? await fromJson(bytes, net) : await fromTable(bytes, net)
  } catch (error) {
    if (error instanceof DOMException) return refused('unread')
    throw error
  }
}

async function fromJson(bytes: Uint8Array, net: NetworkOutline): Promise<Read> {
  const { ExamplesError, fitExamples, parseExamplesFile } = await import('@botgarten/programs/examples')
  try {
    const file = parseExamplesFile(new TextDecoder().decode(bytes))
    return { kind: 'examples', examples: fitExamples(file, net), outside: 0 }
  } catch (error) {
    if (error instanceof ExamplesError) return refused(error.problem, error.facts)
    throw error
  }
}

const byHand: readonly string[] = ['noHeading', 'unknownColumn', 'missingColumn', 'twiceColumn']

async function fromTable(bytes: Uint8Array, net: NetworkOutline): Promise<Read> {
  const { decodeTable, readTable, TableError } = await import('@botgarten/content/tables')
  const limits = { rows: mostOf.rows, columns: 1000, largest: 1e9 }
  try {
    const { columns, rows } = readTable(decodeTable(bytes).text, limits, { decimalComma: false })
    return await inColumns({ columns, rows }, net)
  } catch (error) {
    if (error instanceof TableError) return refused(`table.${error.problem}`, error.facts)
    throw error
  }
}

/** Examples of a table whose columns are named by neurons; else its columns have to be put to them. */
export async function inColumns(table: LooseTable, net: NetworkOutline): Promise<Read> {
  const { ExamplesError, examplesFromTable } = await import('@botgarten/programs/examples')
  const ids = (all: NetworkOutline['inputs']) => all.map(({ id }) => id)
  try {
    return { kind: 'examples', ...examplesFromTable(table, ids(net.inputs), ids(net.outputs)) }
  } catch (error) {
    if (!(error instanceof ExamplesError)) throw error
    if (byHand.includes(error.problem)) return { kind: 'columns', table }
    return refused(error.problem, error.facts)
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
