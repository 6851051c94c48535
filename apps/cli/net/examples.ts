import {
  findingsIn,
  shownPairs,
  type ExampleFinding,
  type Table,
} from '@botgarten/learning/neural-network/examples'
import { examplesCsv, mirrorIn, wheelsIn } from '@botgarten/programs/examples'
import type { Command } from '../commands.ts'
import { CallError } from '../errors.ts'
import { write } from '../files.ts'
import { options } from '../options.ts'
import { message } from '../words.ts'
import { emptyFor, readExamples } from './read-examples.ts'
import { sourceOf, type Source } from './source.ts'

const known = {
  solution: { type: 'boolean' },
  examples: { type: 'string' },
  brain: { type: 'string' },
  check: { type: 'boolean' },
  all: { type: 'boolean' },
  csv: { type: 'string' },
  json: { type: 'boolean' },
} as const

/** `botgarten examples FILE|CARD …`: what a network was shown, and what there is to ask about it. */
export const examples: Command = { options: known, execute: look }

function look(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [what, ...more] = positionals
  if (!what || more.length > 0) throw new CallError('call.examplesWhat')
  const source = sourceOf(what, values)
  const { network, brain } = source
  const shown =
    values.examples === undefined
      ? (brain.examples ?? emptyFor(network))
      : readExamples(values.examples, network)
  if (values.csv !== undefined) write(values.csv, examplesCsv(shown, values.all))
  const table = tableOf(source, shown)
  const rows = { rows: shown.rows.length, on: table.pairs.length, drives: shown.drives.length }
  const findings = values.check ? findingsIn(table) : undefined
  if (values.json) return JSON.stringify({ ...rows, ...(findings && { findings: findings.map(counted) }) })
  return [message('examples.table', rows), ...(findings ?? []).map((one) => `  ${said(counted(one))}`)].join(
    '\n',
  )
}

function tableOf({ network, brain, config }: Source, shown: NonNullable<Source['brain']['examples']>): Table {
  const ids = (neurons: typeof network.inputs) => neurons.map(({ id }) => id)
  const [inputs, outputs] = [ids(network.inputs), ids(network.outputs)]
  const settings = brain.practice?.settings
  const sizes = brain.layers.map((layer) => layer.length)
  const links = sizes.slice(1).reduce((sum, size, index) => sum + size * sizes[index]!, 0)
  const biases = settings?.bias === 'on' ? sizes.slice(1).reduce((a, b) => a + b, 0) : 0
  return {
    ...{ pairs: shownPairs(shown, inputs, outputs).pairs, inputs, outputs, knobs: links + biases },
    wheels: wheelsIn(network, config),
    mirror: (settings?.mirror ?? true) ? mirrorIn(network, config) : null,
  }
}

/** Rows counted from 1, as they stand in the table. */
function counted(finding: ExampleFinding): ExampleFinding {
  if ('others' in finding)
    return { ...finding, row: finding.row + 1, others: finding.others.map((row) => row + 1) }
  if (finding.kind === 'oddOne') return { ...finding, row: finding.row + 1 }
  return finding.kind === 'sleeping' ? { ...finding, rows: finding.rows.map((row) => row + 1) } : finding
}

/** So many rows are named in one sentence. */
const mostNamed = 6

function said(finding: ExampleFinding): string {
  switch (finding.kind) {
    case 'contradiction':
    case 'blind': {
      const others = finding.others.slice(0, mostNamed).join(', ')
      return message(`examples.${finding.kind}`, { row: finding.row, others })
    }
    case 'oddOne':
      return message('examples.oddOne', { row: finding.row })
    case 'oneSided':
      return message('examples.oneSided', { left: finding.left, right: finding.right })
    case 'neverSeen':
      return message('examples.neverSeen', { readings: finding.readings.join(', ') })
    case 'allAlike':
      return message('examples.allAlike', { column: finding.column, value: finding.value })
    case 'sleeping':
      return message('examples.sleeping', { count: finding.rows.length })
    case 'few':
      return message(finding.isMirrored ? 'examples.fewMirrored' : 'examples.few', {
        rows: finding.rows,
        knobs: finding.knobs,
      })
  }
}
