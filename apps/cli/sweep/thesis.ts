import { csvOf, pieceOf, rowsOf, thesisWork } from '@botgarten/experiments/sweep'
import type { Command } from '../commands.ts'
import { seedOf } from '../learn-options.ts'
import { findMap } from '../maps.ts'
import { options, refuseMore, wholeNumberIn } from '../options.ts'
import { threadsIn } from './sweep.ts'
import { handOut, shardIn, tableOptions, tell } from './table.ts'

const known = { ...tableOptions, seed: { type: 'string' } } as const

/** `botgarten learn q-thesis …`: 225 settings, 50 runs each, on three maps, by the study rules. */
export const thesis: Command = { options: known, execute: sweepThesis }

async function sweepThesis(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const runs = wholeNumberIn('runs', values.runs, 50, 1, 1_000_000)
  const all = thesisWork((id) => findMap(id).map, { runs, seed: seedOf(values) })
  const shard = shardIn(values.shard)
  const mine = pieceOf(all, shard)
  const rows = await rowsOf(mine, threadsIn(values.threads), (count) => tell(count, mine.length))
  const named = rows.map((row, index) => ({ map: mine[index]!.map, ...row }))
  if (values.json) return JSON.stringify(named)
  return handOut(csvOf(named, shard, true), values.csv, rows.length)
}
