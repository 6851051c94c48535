import { writeFileSync } from 'node:fs'
import { CallError, FileError, options, wholeNumberIn } from '../errors.ts'
import { algorithmOf, limitsOf, rulesOf, seedOf, taskOf, taskOptions } from '../learn-options.ts'
import { findMap } from '../maps.ts'
import { listOptions, settingsIn } from './grid.ts'
import type { Row } from './runs.ts'
import { rowsOf } from './threads.ts'

const known = {
  ...taskOptions,
  ...listOptions,
  runs: { type: 'string' },
  threads: { type: 'string' },
  shard: { type: 'string' },
  csv: { type: 'string' },
  json: { type: 'boolean' },
} as const

const columns = [
  ...(['alpha', 'gamma', 'nu', 'rho', 'alphaDecay', 'rhoDecay', 'runs', 'foundShortest'] as const),
  ...(['shortestAtEnd', 'anyAtEnd', 'medianFirst', 'meanFirst'] as const),
]

/** `botgarten learn q-sweep …`: all combinations of the given lists, many runs each, on all cores. */
export async function sweep(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  if (positionals.length > 0)
    throw new CallError(`"learn q-sweep" does not know what to do with "${positionals[0]}".`)
  if (values.map === undefined) throw new CallError('--map is needed: a map by its name, or an SVG file.')
  const job = {
    task: taskOf(findMap(values.map), values),
    ...{ rules: rulesOf(values), algorithm: algorithmOf(values), seed: seedOf(values) },
    ...limitsOf(values),
    runs: wholeNumberIn('runs', values.runs, 50, 1, 1_000_000),
  }
  const { part, parts } = shardIn(values.shard)
  const all = settingsIn(values)
  const mine = all.slice(
    Math.floor(((part - 1) * all.length) / parts),
    Math.floor((part * all.length) / parts),
  )
  const threads =
    values.threads === undefined ? undefined : wholeNumberIn('threads', values.threads, 1, 1, 1024)
  const rows = await rowsOf(job, mine, threads, (count) => tell(count, mine.length))
  if (values.json) return JSON.stringify(rows)
  const table = csvOf(rows, part === 1)
  if (values.csv === undefined) return table.trimEnd()
  writeTable(values.csv, table)
  return `${rows.length} settings, ${job.runs} runs each: ${values.csv}`
}

/** `I/N`: the I-th of N parts. The header is in the first, so that the joined parts are the whole. */
function shardIn(text = '1/1') {
  const [, part, parts] = /^(\d+)\/(\d+)$/.exec(text)?.map(Number) ?? []
  if (part === undefined || parts === undefined || part < 1 || part > parts)
    throw new CallError(`--shard takes a part and how many there are, such as 2/8, not "${text}".`)
  return { part, parts }
}

/** Progress goes beside the result, and only to somebody who looks. */
function tell(count: number, of: number): void {
  if (process.stderr.isTTY) process.stderr.write(`\r${count} of ${of}${count === of ? '\n' : ''}`)
}

function csvOf(rows: readonly Row[], withHeader: boolean): string {
  const lines = rows.map((row) => columns.map((column) => row[column] ?? '').join(','))
  return [...(withHeader ? [columns.join(',')] : []), ...lines].map((line) => line + '\n').join('')
}

function writeTable(path: string, text: string): void {
  try {
    writeFileSync(path, text)
  } catch (error) {
    throw new FileError(`"${path}" cannot be written: ${(error as Error).message}`)
  }
}
