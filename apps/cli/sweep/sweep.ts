import { csvOf, pieceOf, rowsOf } from '@botgarten/experiments/sweep'
import type { Command } from '../commands.ts'
import { CallError } from '../errors.ts'
import { algorithmOf, limitsOf, rulesOf, seedOf, taskOf, taskOptions } from '../learn-options.ts'
import { findMap } from '../maps.ts'
import { options, refuseMore, wholeNumberIn } from '../options.ts'
import { listOptions, settingsIn } from './grid.ts'
import { handOut, shardIn, tableOptions, tell } from './table.ts'

const known = { ...taskOptions, ...listOptions, ...tableOptions } as const

/** `botgarten learn q-sweep …`: all combinations of the given lists, many runs each, on all cores. */
export const sweep: Command = { options: known, execute: sweepAll }

async function sweepAll(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  if (values.map === undefined) throw new CallError('call.needsMap')
  const job = {
    task: taskOf(findMap(values.map), values),
    ...{ rules: rulesOf(values), algorithm: algorithmOf(values), seed: seedOf(values) },
    ...limitsOf(values),
    runs: wholeNumberIn('runs', values.runs, 50, 1, 1_000_000),
  }
  const shard = shardIn(values.shard)
  const mine = pieceOf(settingsIn(values), shard)
  const work = mine.map((setting) => ({ job, setting }))
  const rows = await rowsOf(work, threadsIn(values.threads), (count) => tell(count, mine.length))
  if (values.json) return JSON.stringify(rows)
  return handOut(csvOf(rows, shard), values.csv, rows.length)
}

export const threadsIn = (text: string | undefined) =>
  text === undefined ? undefined : wholeNumberIn('threads', text, 1, 1, 1024)
