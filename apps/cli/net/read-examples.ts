import { decodeTable, readTable, TableError } from '@botgarten/content/tables'
import { mostOf, noExamples, type Examples } from '@botgarten/learning/neural-network/examples'
import type { NetworkOutline } from '@botgarten/programs'
import {
  ExamplesError,
  examplesFromTable,
  fitExamples,
  parseExamplesFile,
} from '@botgarten/programs/examples'
import { FileError } from '../errors.ts'
import { readBytes } from '../files.ts'
import { note } from '../notes.ts'
import { message } from '../words.ts'

/** In megabytes. */
const tooLarge = 5

const idsOf = (neurons: NetworkOutline['inputs']) => neurons.map(({ id }) => id)

/** The examples of a network that has none yet. */
export const emptyFor = ({ inputs, outputs }: NetworkOutline): Examples =>
  noExamples(idsOf(inputs), idsOf(outputs))

/** Examples of a CSV or JSON file for a network. @throws {FileError} */
export function readExamples(path: string, network: NetworkOutline): Examples {
  const bytes = readBytes(path, tooLarge)
  try {
    return path.toLowerCase().endsWith('.json')
      ? fitExamples(parseExamplesFile(bytes.toString('utf8')), network)
      : fromCsv(bytes, network)
  } catch (error) {
    throw new FileError('file.noExamples', { path, why: whyOf(error) })
  }
}

function whyOf(error: unknown): string {
  if (error instanceof TableError) return message(`table.${error.problem}`, error.facts)
  if (error instanceof ExamplesError) return message(`examples.${error.problem}`, error.facts)
  throw error
}

function fromCsv(bytes: Uint8Array, network: NetworkOutline): Examples {
  const columns = network.inputs.length + network.outputs.length + 2
  const table = readTable(decodeTable(bytes).text, { rows: mostOf.rows, columns, largest: 1e6 })
  const named = table.reading.heading ? table : { ...table, columns: table.columns.map((_, k) => `${k + 1}`) }
  const { examples, outside } = examplesFromTable(named, idsOf(network.inputs), idsOf(network.outputs))
  if (outside > 0) note(message('examples.outside', { count: outside }))
  return examples
}
